// SPDX-License-Identifier: BSD-3-Clause
#ifndef CloudCase_h
#define CloudCase_h

#include "Support/Images/ShadowScene.h"

namespace reference
{

/// Mean cosine of the scattering angle for water droplets.
constexpr double CloudAnisotropy = 0.85;

/// Returns a scene with a cumulus cloud, lit by the sun from above and from behind the cloud. The
/// cloud has an optical depth of about 25 and no absorption. Its grid has \a cells cells along its
/// longest edge, and the image has \a pixels x \a pixels pixels.
ShadowScene MakeCloudCase(int cells, int pixels);

}

#endif

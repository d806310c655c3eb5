// SPDX-License-Identifier: BSD-3-Clause
#ifndef CloudCase_h
#define CloudCase_h

#include "Support/Images/ShadowScene.h"

namespace reference
{

/// Mean cosine of the scattering angle of water drops.
constexpr double CloudAnisotropy = 0.85;

/// Returns a cumulus with an optical depth of about 25, lit by the sun from behind and above, in a
/// square image. The grid has \a cells cells along its longest edge. There is no absorption.
ShadowScene MakeCloudCase(int cells, int pixels);

}

#endif

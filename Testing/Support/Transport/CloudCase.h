// SPDX-License-Identifier: BSD-3-Clause
#ifndef CloudCase_h
#define CloudCase_h

#include "Support/Pictures/ShadowScene.h"

namespace reference
{

/// The mean cosine of the angle by which drops of water turn light.
constexpr double CloudAnisotropy = 0.85;

/// A cumulus of an optical depth of about 25 in the sun, which stands behind it and above, so many
/// cells along its longest edge, in a square picture. It absorbs nothing.
ShadowScene MakeCloudCase(int cells, int pixels);

}

#endif

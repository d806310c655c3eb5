// SPDX-License-Identifier: BSD-3-Clause
#ifndef FinerPicture_h
#define FinerPicture_h

#include "Support/Pictures/RgbaPicture.h"

namespace approximations
{
/// How many lines of sight along a pixel's edge make a picture that settings are compared with
/// which change what a pixel is the mean of.
constexpr int Finer = 3;

/// The picture whose pixels are the means of Finer x Finer pixels.
reference::RgbaPicture MakeCoarser(const reference::RgbaPicture& fine);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LightPoints_h
#define LightPoints_h

#include "Support/Images/ReferenceLightSource.h" // for the points

#include <vector>

/**
 * Area lights as sets of sample points, which are the same for every illuminated point.
 */
namespace reference
{

/// Returns count x count points of the parallelogram center + s \a side + t \a up, with s and t
/// from -1/2 to 1/2. Each of count^2 equal parts has one point. All s differ and are evenly spaced,
/// and so are all t. Therefore, a shadow edge parallel to a side has steps of only 1 / count^2.
std::vector<LightPoint> MakeSquarePoints(
  const Double3& center, const Double3& side, const Double3& up, int count);

/// Returns \a count points of the ellipse center + r (cos(a) side + sin(a) up) with r up to 1/2.
/// Each represents the same area. Consecutive points differ by the golden angle.
std::vector<LightPoint> MakeRoundPoints(
  const Double3& center, const Double3& side, const Double3& up, int count);

}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LightPoints_h
#define LightPoints_h

#include "Support/Pictures/ReferenceLightSource.h" // for the points

#include <vector>

/**
 * Lights with an extent as sets of points, the same for every place that they light.
 */
namespace reference
{

/// Returns count x count points of the parallelogram center + s \a side + t \a up, s and t from
/// -1/2 to 1/2: one in each of as many equal parts, and so that the points' s, as their t, are all
/// different and evenly spaced. A shadow's edge along a side then has steps of 1 / count^2.
std::vector<LightPoint> MakeSquarePoints(
  const Double3& center, const Double3& side, const Double3& up, int count);

/// Returns count points of the ellipse center + r (cos(a) side + sin(a) up), r at most 1/2, of
/// equal area each, by the golden angle.
std::vector<LightPoint> MakeRoundPoints(
  const Double3& center, const Double3& side, const Double3& up, int count);

}

#endif

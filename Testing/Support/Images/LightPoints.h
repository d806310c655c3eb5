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
/// from -1/2 to 1/2. There is one point in each of count^2 equal parts. The values of s differ for
/// all points and are evenly spaced, and so are those of t. Therefore, a shadow edge parallel to a
/// side has steps of only 1 / count^2.
std::vector<LightPoint> MakeParallelogramLightPoints(
  const Double3& center, const Double3& side, const Double3& up, int count);

/// Returns \a count points center + r (cos(a) side + sin(a) up) of an ellipse, with r up to 1/2.
/// Each point represents the same area. The angles a of consecutive points differ by the golden
/// angle.
std::vector<LightPoint> MakeEllipseLightPoints(
  const Double3& center, const Double3& side, const Double3& up, int count);

}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_BentAxis_h
#define interlume_BentAxis_h

namespace interlume
{

/**
 * Distance from a curved axis. The axis is a graph over a straight line: at coordinate s along the
 * line, the axis has a two-dimensional offset from the line.
 */
namespace BentAxis
{
/**
 * Returns the squared distance from a point to the tangent of the axis at the point's coordinate s.
 * It approximates the squared distance to the axis. \a offset is the vector from the axis to the
 * point in the plane s = const. \a slope is the derivative of the axis with respect to s.
 */
inline double SquaredDistance(const double offset[2], const double slope[2])
{
  const double along = offset[0] * slope[0] + offset[1] * slope[1];
  return offset[0] * offset[0] + offset[1] * offset[1] -
    along * along / (1.0 + slope[0] * slope[0] + slope[1] * slope[1]);
}
}

}

#endif

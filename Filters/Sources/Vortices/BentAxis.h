// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_BentAxis_h
#define interlume_BentAxis_h

namespace interlume
{

/**
 * A tube around an axis that is a graph over a straight line: the axis passes the line's point s at
 * an offset of two coordinates, which has a slope there.
 */
namespace BentAxis
{
/**
 * Returns the squared distance of a point from the axis, to first order in the axis's curvature. \a
 * offset leads from the axis to the point in the plane s = const, \a slope is the axis's derivative
 * by s.
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

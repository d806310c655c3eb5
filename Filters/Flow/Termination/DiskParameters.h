// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_DiskParameters_h
#define interlume_DiskParameters_h

#include "vtkTerminationSurface.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

/**
 * Parametrization of the unit disk without pole or seam: u = (x + 1) / 2, v = (y + 1) / 2.
 */
namespace DiskParameters
{
/// Computes the parameters of a point. A point outside the disk is moved radially to the edge.
inline void FromPoint(double x, double y, double uv[2])
{
  const double scale = 0.5 / std::max(1.0, std::hypot(x, y));
  uv[0] = 0.5 + scale * x;
  uv[1] = 0.5 + scale * y;
}

/// Computes the point with the given parameters. Returns false if they are outside the disk.
inline bool ToPoint(const double uv[2], double& x, double& y)
{
  x = 2.0 * uv[0] - 1.0;
  y = 2.0 * uv[1] - 1.0;
  const double radius = std::hypot(x, y);
  const double scale = 1.0 / std::max(1.0, radius);
  x *= scale;
  y *= scale;
  return radius <= 1.0 + vtkTerminationSurface::BorderTolerance;
}
}

}

#endif

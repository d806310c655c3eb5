// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_Interpolation_h
#define interlume_Interpolation_h

#include <cmath>

namespace interlume
{

namespace Interpolation
{

/// Interpolates between two values: exact where near equals far, and near itself for a grid point,
/// whatever far holds.
template <typename Out>
Out Between(double near, double far, double weight)
{
  if (weight == 0.0)
  {
    return static_cast<Out>(near);
  }
  const double step = far - near;
  // The step between two finite values may not be finite.
  return static_cast<Out>(
    std::isfinite(step) ? near + weight * step : near * (1.0 - weight) + far * weight);
}

}

}

#endif

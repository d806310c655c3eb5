// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_Interpolation_h
#define interlume_Interpolation_h

#include <cmath>

namespace interlume
{

namespace Interpolation
{

/// Interpolates linearly between two values. The result is exact if \a near equals \a far. At
/// weight 0 the result is \a near, even if \a far is not finite.
template <typename Out>
Out Between(double near, double far, double weight)
{
  if (weight == 0.0)
  {
    return static_cast<Out>(near);
  }
  const double step = far - near;
  // The difference may overflow although both values are finite.
  return static_cast<Out>(
    std::isfinite(step) ? near + weight * step : near * (1.0 - weight) + far * weight);
}

}

}

#endif

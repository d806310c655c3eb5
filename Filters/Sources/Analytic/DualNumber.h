// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_DualNumber_h
#define interlume_DualNumber_h

#include <Eigen/Core>
#include <unsupported/Eigen/AutoDiff>

#include <cmath>

namespace interlume
{

/**
 * A number and its derivatives with respect to three variables. A formula whose number type is a
 * template parameter also yields its exact derivatives if it is evaluated with this type. Store
 * results as DualNumber, not as auto: Eigen's operators return expressions that refer to their
 * operands.
 */
using DualNumber = Eigen::AutoDiffScalar<Eigen::Vector3d>;

/// Functions for double and DualNumber that Eigen does not provide.
namespace DualMath
{
inline double GetValue(double a)
{
  return a;
}
inline double GetValue(const DualNumber& a)
{
  return a.value();
}

/// Returns (1 - exp(-a)) / a, or 1 if a is 0.
inline double MeanExponentialDecay(double a)
{
  return a == 0.0 ? 1.0 : -std::expm1(-a) / a;
}
inline DualNumber MeanExponentialDecay(const DualNumber& a)
{
  // Near 0 the difference below suffers from cancellation, so use the series of the derivative.
  const double x = a.value();
  const double value = MeanExponentialDecay(x);
  const double derivative = std::abs(x) < 1e-3
    ? -0.5 + x * (1.0 / 3.0 - x * (0.125 - x * (1.0 / 30.0 - x / 144.0)))
    : (std::exp(-x) - value) / x;
  return DualNumber(value, derivative * a.derivatives());
}
}

}

#endif

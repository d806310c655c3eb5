// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_DualNumber_h
#define interlume_DualNumber_h

#include <Eigen/Core>
#include <unsupported/Eigen/AutoDiff>

#include <cmath>

namespace interlume
{

/**
 * A number with its derivatives by three variables: a formula written as a template of the type of
 * its numbers gives its exact derivatives when it is called with these. Its results are to be kept
 * as numbers, not as auto: what Eigen's operators return refers to their operands.
 */
using DualNumber = Eigen::AutoDiffScalar<Eigen::Vector3d>;

/// Functions for both kinds of numbers that Eigen has not.
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

/// Computes (1 - exp(-a)) / a, which is 1 at 0.
inline double Decay(double a)
{
  return a == 0.0 ? 1.0 : -std::expm1(-a) / a;
}
inline DualNumber Decay(const DualNumber& a)
{
  // Near 0 the difference below cancels: there the series of the derivative.
  const double x = a.value();
  const double value = Decay(x);
  const double derivative = std::abs(x) < 1e-3
    ? -0.5 + x * (1.0 / 3.0 - x * (0.125 - x * (1.0 / 30.0 - x / 144.0)))
    : (std::exp(-x) - value) / x;
  return DualNumber(value, derivative * a.derivatives());
}
}

}

#endif

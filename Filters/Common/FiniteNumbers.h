// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FiniteNumbers_h
#define interlume_FiniteNumbers_h

#include <algorithm>
#include <cmath>

namespace interlume
{

/**
 * Checks numeric settings.
 */
namespace FiniteNumbers
{
inline bool AreFinite(const double* values, int number)
{
  return std::all_of(values, values + number, [](double value) { return std::isfinite(value); });
}

/// Returns whether a value is valid as a radius or a length: finite and positive.
inline bool IsSize(double value)
{
  return std::isfinite(value) && value > 0.0;
}
}

}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ClampedValue_h
#define interlume_ClampedValue_h

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace interlume
{

/**
 * Assigns clamped values in setters of numbers.
 */
namespace ClampedValue
{
/**
 * Gives \a members the \a values, each clamped to lower ... upper; NaN leaves a member as it is.
 * Returns true when something changed.
 */
template <std::size_t Size>
bool Assign(double (&members)[Size], const double (&values)[Size], double lower, double upper)
{
  bool isChanged = false;
  for (std::size_t i = 0; i < Size; ++i)
  {
    const double value = std::max(lower, std::min(values[i], upper));
    if (!std::isnan(values[i]) && value != members[i])
    {
      members[i] = value;
      isChanged = true;
    }
  }
  return isChanged;
}

/// Gives \a member one value in the same way.
inline bool Assign(double& member, double value, double lower, double upper)
{
  double members[1] = { member };
  const bool isChanged = Assign(members, { value }, lower, upper);
  member = members[0];
  return isChanged;
}
}

}

#endif

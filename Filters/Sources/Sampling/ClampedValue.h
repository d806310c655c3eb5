// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ClampedValue_h
#define interlume_ClampedValue_h

#include "vtkObject.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace interlume
{

/**
 * Assigns clamped values in setters of numeric properties.
 */
namespace ClampedValue
{
/// Largest absolute value of most properties.
constexpr double Largest = 1e12;

/**
 * Assigns \a number \a values to \a members, each clamped to lower ... upper. NaN leaves a member
 * unchanged. Marks \a owner as modified if a member changed.
 */
inline void SetAll(vtkObject* owner, double* members, const double* values, std::size_t number,
  double lower, double upper)
{
  bool isChanged = false;
  for (std::size_t i = 0; i < number; ++i)
  {
    const double value = std::max(lower, std::min(values[i], upper));
    if (!std::isnan(values[i]) && value != members[i])
    {
      members[i] = value;
      isChanged = true;
    }
  }
  if (isChanged)
  {
    owner->Modified();
  }
}

/// Assigns all \a members as SetAll() does.
template <std::size_t Size>
void Set(vtkObject* owner, double (&members)[Size], const double (&values)[Size],
  double lower = -Largest, double upper = Largest)
{
  SetAll(owner, members, values, Size, lower, upper);
}

/// Assigns one \a member as SetAll() does.
inline void Set(
  vtkObject* owner, double& member, double value, double lower = -Largest, double upper = Largest)
{
  SetAll(owner, &member, &value, 1, lower, upper);
}
}

}

#endif

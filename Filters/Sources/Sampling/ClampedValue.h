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
 * Assigns clamped values in setters of numbers.
 */
namespace ClampedValue
{
/**
 * Gives the first \a number \a members of \a owner the \a values, each clamped to lower ... upper;
 * NaN leaves a member as it is. Marks the owner modified when something changed.
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

/// Gives all \a members their values in the same way.
template <std::size_t Size>
void Set(vtkObject* owner, double (&members)[Size], const double (&values)[Size], double lower,
  double upper)
{
  SetAll(owner, members, values, Size, lower, upper);
}

/// Gives \a member one value in the same way.
inline void Set(vtkObject* owner, double& member, double value, double lower, double upper)
{
  SetAll(owner, &member, &value, 1, lower, upper);
}
}

}

#endif

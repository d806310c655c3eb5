// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ArrayMatch_h
#define interlume_ArrayMatch_h

#include "vtkAbstractArray.h"
#include "vtkDataSetAttributes.h"

#include <string>

namespace interlume
{

/**
 * Matches the arrays of two sets of attributes, such as those of two time steps. Arrays correspond
 * by name. Those without a name correspond by their attribute role (scalars, vectors, ...) or, if
 * they have none, by their position among the arrays with neither.
 */
namespace ArrayMatch
{
/// The first character of keys that are not names.
constexpr char KeyMark = '\x1f';

inline bool HasName(vtkAbstractArray* array)
{
  return array->GetName() && *array->GetName();
}

/// Returns a text that corresponding arrays have in common: the name if there is one.
inline std::string GetKey(vtkDataSetAttributes* attributes, vtkAbstractArray* array)
{
  if (HasName(array))
  {
    return array->GetName();
  }
  int position = 0;
  int role = -1;
  for (int a = 0; a < attributes->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* other = attributes->GetAbstractArray(a);
    role = attributes->IsArrayAnAttribute(a);
    if (other == array)
    {
      break;
    }
    position += role < 0 && !HasName(other);
  }
  return KeyMark + (role < 0 ? std::to_string(position) : "role " + std::to_string(role));
}

/// Returns the array of \a to that corresponds to \a array of \a from, or null.
inline vtkAbstractArray* Find(
  vtkDataSetAttributes* from, vtkAbstractArray* array, vtkDataSetAttributes* to)
{
  if (HasName(array))
  {
    return to->GetAbstractArray(array->GetName());
  }
  const std::string key = GetKey(from, array);
  for (int a = 0; a < to->GetNumberOfArrays(); ++a)
  {
    if (GetKey(to, to->GetAbstractArray(a)) == key)
    {
      return to->GetAbstractArray(a);
    }
  }
  return nullptr;
}

/// Removes the names of arrays that are keys.
inline void RemoveKeys(vtkDataSetAttributes* attributes)
{
  for (int a = 0; a < attributes->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = attributes->GetAbstractArray(a);
    if (HasName(array) && *array->GetName() == KeyMark)
    {
      array->SetName(nullptr);
    }
  }
}
}

}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ArrayMatch_h
#define interlume_ArrayMatch_h

#include "vtkAbstractArray.h"
#include "vtkDataSetAttributes.h"

#include <string>

namespace interlume
{

/**
 * Matches the arrays of two attribute sets, for example of two time steps. Arrays are matched by
 * name. Unnamed arrays are matched by their attribute type (scalars, vectors, ...) if they are
 * active attributes, otherwise by their position among the other unnamed arrays.
 */
namespace ArrayMatch
{
/// First character of the keys that GetKey returns for unnamed arrays.
constexpr char KeyMark = '\x1f';

inline bool HasName(vtkAbstractArray* array)
{
  return array->GetName() && *array->GetName();
}

/// Returns a key that is the same for corresponding arrays: the name, or for an unnamed array its
/// attribute type or position.
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

/// Removes the names of arrays that were named by their keys because they had no name.
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

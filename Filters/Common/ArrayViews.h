// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ArrayViews_h
#define interlume_ArrayViews_h

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

namespace interlume
{

/**
 * Converts arrays to a given array class.
 */
namespace ArrayViews
{
/// Returns the array itself if its class is \a Array, otherwise a copy in a new \a Array. \a Array
/// is a vtkAOSDataArrayTemplate.
template <typename Array>
vtkSmartPointer<Array> Get(vtkDataArray* array)
{
  if (Array* same = Array::FastDownCast(array))
  {
    return same;
  }
  auto copy = vtkSmartPointer<Array>::New();
  copy->DeepCopy(array);
  return copy;
}
}

}

#endif

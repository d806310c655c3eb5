// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ArrayViews_h
#define interlume_ArrayViews_h

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

namespace interlume
{

/**
 * Numbers of any type and layout as one class of arrays.
 */
namespace ArrayViews
{
/// Returns an array as an Array, a vtkAOSDataArrayTemplate: itself, or a copy.
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

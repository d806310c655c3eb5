// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_OutputCellArrays_h
#define interlume_OutputCellArrays_h

#include "Output/OutputAllocation.h"

#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

namespace interlume
{

namespace OutputCellArrays
{
/// Adds a cell array with \a number uninitialized values to an output. The output owns the array.
template <typename Array>
Array* Add(vtkUnstructuredGrid* output, const char* name, vtkIdType number)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfValues(number);
  OutputAllocation::PreferLargePages(array);
  output->GetCellData()->AddArray(array);
  return array;
}
}

}

#endif

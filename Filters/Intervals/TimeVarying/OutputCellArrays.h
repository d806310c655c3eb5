// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_OutputCellArrays_h
#define interlume_OutputCellArrays_h

#include "Output/ExtractionMemory.h"

#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

namespace interlume
{

namespace OutputCellArrays
{
/// Adds an array of cells to an output, which has one value for each and keeps it. The values are
/// not set.
template <typename Array>
Array* Add(vtkUnstructuredGrid* output, const char* name, vtkIdType number)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfValues(number);
  ExtractionMemory::PreferLargePages(array);
  output->GetCellData()->AddArray(array);
  return array;
}
}

}

#endif

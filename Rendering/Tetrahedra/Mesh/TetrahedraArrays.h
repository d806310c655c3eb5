// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TetrahedraArrays_h
#define interlume_TetrahedraArrays_h

#include "vtkDataArray.h"

#include <cmath>

namespace interlume
{

/**
 * The arrays of a grid that are read; null where there is none.
 */
struct TetrahedraArrays
{
  vtkDataArray* Scalars = nullptr;
  bool ScalarsAreOfCells = false;
  vtkDataArray* DeltaT = nullptr;
  vtkDataArray* Layers = nullptr;

  bool operator==(const TetrahedraArrays& other) const
  {
    return this->Scalars == other.Scalars && this->ScalarsAreOfCells == other.ScalarsAreOfCells &&
      this->DeltaT == other.DeltaT && this->Layers == other.Layers;
  }

  static bool IsFinite(vtkDataArray* array, vtkIdType id)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      if (!std::isfinite(array->GetComponent(id, c)))
      {
        return false;
      }
    }
    return true;
  }

  /// Returns whether a point, or a cell, has only values that can be used.
  bool HasPoint(vtkIdType point) const
  {
    return (!this->Scalars || this->ScalarsAreOfCells || IsFinite(this->Scalars, point)) &&
      (!this->DeltaT || IsFinite(this->DeltaT, point));
  }
  bool HasCell(vtkIdType cell) const
  {
    return !this->Scalars || !this->ScalarsAreOfCells || IsFinite(this->Scalars, cell);
  }
};

}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TetrahedraArrays_h
#define interlume_TetrahedraArrays_h

#include "vtkDataArray.h"

#include <cmath>

namespace interlume
{

/**
 * Arrays of a grid from which the mesh and its fields are built. Unused arrays are null.
 */
struct TetrahedraArrays
{
  vtkDataArray* Scalars = nullptr;
  bool HasCellScalars = false;
  vtkDataArray* DeltaT = nullptr;
  vtkDataArray* Layers = nullptr;

  bool operator==(const TetrahedraArrays& other) const
  {
    return this->Scalars == other.Scalars && this->HasCellScalars == other.HasCellScalars &&
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

  /// Return true if all array values of a point or cell are finite.
  bool HasPoint(vtkIdType point) const
  {
    return (!this->Scalars || this->HasCellScalars || IsFinite(this->Scalars, point)) &&
      (!this->DeltaT || IsFinite(this->DeltaT, point));
  }
  bool HasCell(vtkIdType cell) const
  {
    return !this->Scalars || !this->HasCellScalars || IsFinite(this->Scalars, cell);
  }
};

}

#endif

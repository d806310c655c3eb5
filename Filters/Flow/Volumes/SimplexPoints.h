// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SimplexPoints_h
#define interlume_SimplexPoints_h

#include "Common/StoredIds.h"

#include "vtkCellArray.h"
#include "vtkUnstructuredGrid.h"

namespace interlume
{

/**
 * @class   SimplexPoints
 * @brief   thread-safe access to the points of cells with the same number of points
 */
class SimplexPoints
{
public:
  /// Reads cells of \a size points each. The grid must outlive this object.
  SimplexPoints(vtkUnstructuredGrid* grid, int size)
    : Size(size)
    , Number(grid->GetNumberOfCells())
  {
    if (this->Number > 0)
    {
      this->Ids.Build(grid->GetCells()->GetConnectivityArray());
    }
  }

  vtkIdType GetNumber() const { return this->Number; }
  vtkIdType Get(vtkIdType cell, int corner) const
  {
    return this->Ids.Get(cell * this->Size + corner);
  }

private:
  int Size;
  vtkIdType Number;
  StoredIds Ids;
};

/// Returns the values of an array of type vtkIdTypeArray, such as OriginCell of an extraction.
inline const vtkIdType* GetOrigins(vtkDataSetAttributes* attributes, const char* name)
{
  return vtkIdTypeArray::SafeDownCast(attributes->GetArray(name))->GetPointer(0);
}

}

#endif

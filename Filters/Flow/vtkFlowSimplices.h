#ifndef vtkFlowSimplices_h
#define vtkFlowSimplices_h

#include "vtkCellArray.h"
#include "vtkStoredIds.h"
#include "vtkUnstructuredGrid.h"

/**
 * @class   vtkFlowSimplices
 * @brief   the points of cells that all have the same number of them, read by threads
 */
class vtkFlowSimplices
{
public:
  /// Cells of \a size points each. The grid is kept by the caller.
  vtkFlowSimplices(vtkUnstructuredGrid* grid, int size)
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
  vtkStoredIds Ids;
};

#endif

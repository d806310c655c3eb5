#ifndef vtkFlowSimplices_h
#define vtkFlowSimplices_h

#include "vtkCellArray.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
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
    vtkCellArray* cells = grid->GetCells();
    if (this->Number == 0)
    {
      return;
    }
    if (cells->IsStorage64Bit())
    {
      this->Wide = cells->GetConnectivityArray64()->GetPointer(0);
    }
    else
    {
      this->Narrow = cells->GetConnectivityArray32()->GetPointer(0);
    }
  }

  vtkIdType GetNumber() const { return this->Number; }
  vtkIdType Get(vtkIdType cell, int corner) const
  {
    const vtkIdType place = cell * this->Size + corner;
    return this->Narrow ? static_cast<vtkIdType>(this->Narrow[place])
                        : static_cast<vtkIdType>(this->Wide[place]);
  }

private:
  int Size;
  vtkIdType Number;
  const vtkTypeInt32* Narrow = nullptr;
  const vtkTypeInt64* Wide = nullptr;
};

#endif

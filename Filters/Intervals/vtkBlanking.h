#ifndef vtkBlanking_h
#define vtkBlanking_h

#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkUnsignedCharArray.h"

/**
 * @class   vtkBlanking
 * @brief   which cells and points of a dataset do not count, by its ghost arrays
 */
struct vtkBlanking
{
  vtkUnsignedCharArray* CellGhosts = nullptr;
  vtkUnsignedCharArray* PointGhosts = nullptr;

  void SetBlanking(vtkDataSet* data)
  {
    this->CellGhosts = data->GetCellGhostArray();
    this->PointGhosts = data->GetPointGhostArray();
  }

  /// Whether the ghost arrays say that a cell does not count.
  bool IsCellBlanked(vtkIdType cell) const
  {
    constexpr unsigned char blanked = vtkDataSetAttributes::DUPLICATECELL |
      vtkDataSetAttributes::REFINEDCELL | vtkDataSetAttributes::HIDDENCELL;
    return this->CellGhosts && (this->CellGhosts->GetValue(cell) & blanked);
  }
  bool IsPointBlanked(vtkIdType point) const
  {
    return this->PointGhosts &&
      (this->PointGhosts->GetValue(point) & vtkDataSetAttributes::HIDDENPOINT);
  }
  bool HasBlanking() const { return this->CellGhosts || this->PointGhosts; }
};

#endif

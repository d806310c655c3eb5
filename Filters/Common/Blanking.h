// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_Blanking_h
#define interlume_Blanking_h

#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkUnsignedCharArray.h"

#include <cstdint>
#include <cstring>

namespace interlume
{

/**
 * @class   Blanking
 * @brief   cells and points that the ghost arrays of a dataset exclude
 */
struct Blanking
{
  vtkUnsignedCharArray* CellGhosts = nullptr;
  vtkUnsignedCharArray* PointGhosts = nullptr;

  void SetBlanking(vtkDataSet* data)
  {
    this->CellGhosts = data->GetCellGhostArray();
    this->PointGhosts = data->GetPointGhostArray();
  }

  /// Returns whether a cell is excluded because it is a duplicate, refined or hidden cell.
  bool IsCellBlanked(vtkIdType cell) const
  {
    return this->HasCell(cell, vtkDataSetAttributes::DUPLICATECELL | Hidden);
  }
  /// Returns whether a cell is a refined or hidden cell.
  bool IsCellHidden(vtkIdType cell) const { return this->HasCell(cell, Hidden); }
  /// Returns whether a cell is a duplicate of a cell in another piece.
  bool IsCellDuplicate(vtkIdType cell) const
  {
    return this->HasCell(cell, vtkDataSetAttributes::DUPLICATECELL);
  }
  bool IsPointBlanked(vtkIdType point) const
  {
    return this->PointGhosts &&
      (this->PointGhosts->GetValue(point) & vtkDataSetAttributes::HIDDENPOINT);
  }
  bool HasBlanking() const { return this->CellGhosts || this->PointGhosts; }

  /// Returns the first cell in [\a first, \a last) that has a nonzero ghost value, or \a last.
  vtkIdType FindMarkedCell(vtkIdType first, vtkIdType last) const
  {
    if (!this->CellGhosts)
    {
      return last;
    }
    const unsigned char* marks = this->CellGhosts->GetPointer(0);
    // Eight cells are tested at a time, since the ghost value of most cells is 0.
    std::uint64_t eight = 0;
    constexpr vtkIdType number = sizeof(eight);
    for (; last - first >= number; first += number)
    {
      std::memcpy(&eight, marks + first, sizeof(eight));
      if (eight != 0)
      {
        break;
      }
    }
    while (first < last && marks[first] == 0)
    {
      ++first;
    }
    return first;
  }

private:
  static constexpr unsigned char Hidden =
    vtkDataSetAttributes::REFINEDCELL | vtkDataSetAttributes::HIDDENCELL;

  bool HasCell(vtkIdType cell, unsigned char types) const
  {
    return this->CellGhosts && (this->CellGhosts->GetValue(cell) & types);
  }
};

}

#endif

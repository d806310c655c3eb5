// SPDX-License-Identifier: BSD-3-Clause
#include "Grid/GridCellRange.h"

#include "Common/Blanking.h"

#include <algorithm>

namespace interlume
{

namespace
{
// Returns the first cell in [first, last) that is not blanked, or last if there is none.
vtkIdType FindIncluded(const Blanking& blanking, vtkIdType first, vtkIdType last)
{
  while (first < last && blanking.IsCellBlanked(first))
  {
    ++first;
  }
  return first;
}
}

GridCellRange::GridCellRange(const int dimensions[3])
  : First{ { 0, 0, 0 } }
  , Last{ { dimensions[0] - 1, dimensions[1] - 1, dimensions[2] - 1 } }
{
}

vtkIdType GridCellRange::GetNumberOfCells() const
{
  return (this->Last[0] - this->First[0]) * (this->Last[1] - this->First[1]) *
    (this->Last[2] - this->First[2]);
}

bool GridCellRange::Shrink(const Blanking& blanking, const int dimensions[3])
{
  if (!blanking.CellGhosts || blanking.PointGhosts)
  {
    return false;
  }
  const vtkIdType cells[3] = { dimensions[0] - 1, dimensions[1] - 1, dimensions[2] - 1 };
  std::array<vtkIdType, 3> first = { { cells[0], cells[1], cells[2] } };
  std::array<vtkIdType, 3> last = { { 0, 0, 0 } };
  vtkIdType included = 0;
  for (vtkIdType k = 0; k < cells[2]; ++k)
  {
    for (vtkIdType j = 0; j < cells[1]; ++j)
    {
      const vtkIdType begin = (j + k * cells[1]) * cells[0];
      const vtkIdType end = begin + cells[0];
      const vtkIdType firstIncluded = FindIncluded(blanking, begin, end);
      const vtkIdType endIncluded = blanking.FindMarkedCell(firstIncluded, end);
      if (firstIncluded == end)
      {
        continue;
      }
      if (FindIncluded(blanking, endIncluded, end) != end)
      {
        return false;
      }
      const vtkIdType low[3] = { firstIncluded - begin, j, k };
      const vtkIdType high[3] = { endIncluded - begin, j + 1, k + 1 };
      for (int axis = 0; axis < 3; ++axis)
      {
        first[axis] = std::min(first[axis], low[axis]);
        last[axis] = std::max(last[axis], high[axis]);
      }
      included += endIncluded - firstIncluded;
    }
  }
  this->First = first;
  this->Last = last;
  // The included cells fill their bounding box if there are as many of them as cells in the box.
  return included > 0 && included == this->GetNumberOfCells();
}

bool GridCellRange::AnyOutside(
  const int dimensions[3], const std::function<bool(vtkIdType, vtkIdType)>& work) const
{
  // Range, along each axis, of points whose cells are all in the box.
  vtkIdType begin[3];
  vtkIdType end[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    begin[axis] = this->First[axis] == 0 ? 0 : this->First[axis] + 1;
    end[axis] = this->Last[axis] + (this->Last[axis] == dimensions[axis] - 1 ? 1 : 0);
  }
  for (vtkIdType k = 0; k < dimensions[2]; ++k)
  {
    for (vtkIdType j = 0; j < dimensions[1]; ++j)
    {
      const vtkIdType first = (j + k * dimensions[1]) * dimensions[0];
      const vtkIdType last = first + dimensions[0];
      const bool isWithin = j >= begin[1] && j < end[1] && k >= begin[2] && k < end[2];
      const vtkIdType low = isWithin ? first + std::min<vtkIdType>(begin[0], dimensions[0]) : last;
      const vtkIdType high = isWithin ? std::max(first + end[0], low) : last;
      if ((first < low && work(first, low)) || (high < last && work(high, last)))
      {
        return true;
      }
    }
  }
  return false;
}

}

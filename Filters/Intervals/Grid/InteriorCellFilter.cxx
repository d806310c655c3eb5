// SPDX-License-Identifier: BSD-3-Clause
#include "Grid/InteriorCellFilter.h"

#include "Common/ParallelFor.h"

#include "vtkDataArray.h"

#include <algorithm>

namespace interlume
{

void InteriorCellPass::ExcludePointsOutside(vtkDataArray* array, double lower, double upper)
{
  const vtkIdType number = array->GetNumberOfTuples();
  this->Points.resize(number, 1);
  ParallelFor(0, number,
    [&](vtkIdType p)
    {
      const double value = array->GetComponent(p, 0);
      // Both comparisons are false for NaN.
      this->Points[p] &= static_cast<unsigned char>(value >= lower && value <= upper);
    });
}

InteriorCellFilter::InteriorCellFilter(
  vtkDataSet* original, const std::vector<vtkIdType>* originals, const InteriorCellPass& pass)
  : Original(original)
  , Originals(originals)
  , Marks(pass.Points.empty() ? nullptr : pass.Points.data())
  , FirstPassed(pass.First < 0 ? original->GetNumberOfCells() : pass.First)
{
  vtkUnstructuredGrid* grid = vtkUnstructuredGrid::SafeDownCast(original);
  if (originals && grid)
  {
    this->Types = GridCells::GetTypes(grid);
  }
  if (originals && pass.First < 0)
  {
    this->FirstPassed = static_cast<vtkIdType>(originals->size());
  }
}

vtkIdType InteriorCellFilter::GetEndOfParts(vtkIdType cell) const
{
  const auto begin = this->Originals->begin() + cell;
  return std::upper_bound(begin, this->Originals->end(), *begin) - this->Originals->begin();
}

}

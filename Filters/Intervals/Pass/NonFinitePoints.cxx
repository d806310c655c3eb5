// SPDX-License-Identifier: BSD-3-Clause
#include "Pass/NonFinitePoints.h"

#include "Common/Blanking.h"
#include "Common/FiniteNumbers.h"
#include "Common/GridCheck.h"
#include "Grid/CellCorners.h"
#include "Output/ThreadGrain.h"
#include "Scalars/ExtractionDispatch.h"
#include "Scalars/RowKernels.h"

#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <sstream>
#include <type_traits>

namespace interlume
{

namespace
{
bool AreFinite(vtkDataArray* coordinates)
{
  const auto contiguous = ExtractionDispatch::MakeContiguous(coordinates);
  const vtkIdType number = contiguous->GetNumberOfValues();
  std::atomic<bool> areFinite(true);
  ExtractionDispatch::Execute(contiguous,
    [&](const auto* values)
    {
      if constexpr (std::is_floating_point<std::decay_t<decltype(*values)>>::value)
      {
        vtkSMPTools::For(0, number, ThreadGrain,
          [&](vtkIdType first, vtkIdType last)
          {
            if (!RowKernels::AreFinite(values + first, last - first))
            {
              areFinite = false;
            }
          });
      }
      return true;
    });
  return areFinite;
}

bool AreFinite(vtkPoints* points)
{
  using GridCheck::CheckedArrays;
  const CheckedArrays::Key key = CheckedArrays::MakeKey(points);
  if (CheckedArrays::Has(key))
  {
    return true;
  }
  const bool areFinite = AreFinite(points->GetData());
  if (areFinite)
  {
    CheckedArrays::Add(key);
  }
  return areFinite;
}

bool IsPointFinite(vtkDataSet* grid, vtkIdType point)
{
  double x[3];
  grid->GetPoint(point, x);
  return FiniteNumbers::AreFinite(x, 3);
}

// Returns whether the coordinates of all points are finite.
bool AreFinite(vtkDataSet* grid)
{
  if (auto* set = vtkPointSet::SafeDownCast(grid))
  {
    return !set->GetPoints() || AreFinite(set->GetPoints());
  }
  if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(grid))
  {
    return AreFinite(rectilinear->GetXCoordinates()) && AreFinite(rectilinear->GetYCoordinates()) &&
      AreFinite(rectilinear->GetZCoordinates());
  }
  // NaN or infinity in the origin, spacing or direction of image data affects the first or last
  // point.
  return vtkImageData::SafeDownCast(grid) && grid->GetNumberOfPoints() > 0 &&
    IsPointFinite(grid, 0) && IsPointFinite(grid, grid->GetNumberOfPoints() - 1);
}

// Returns the number of leading points of a cell that determine whether it is skipped.
vtkIdType GetNumberOfCorners(int type, vtkIdType points, int dimension)
{
  const CellCorners corners = CellCorners::Of(type);
  const auto hasPointsOnly = dimension == 2 ? CellCorners::SURFACE : CellCorners::POLYHEDRAL;
  return corners.HasTable(dimension)                  ? corners.NumberOfCorners
    : corners.Kind == hasPointsOnly || dimension == 4 ? points
                                                      : 0;
}
}

NonFinitePoints::NonFinitePoints(vtkDataSet* grid)
{
  if (AreFinite(grid))
  {
    return;
  }
  this->Marks.resize(static_cast<std::size_t>(grid->GetNumberOfPoints()));
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    this->Marks[p] = !IsPointFinite(grid, p);
  }
}

std::string NonFinitePoints::Describe(vtkDataSet* grid, int dimension) const
{
  Blanking blanking;
  blanking.SetBlanking(grid);
  vtkIdType skipped = 0;
  std::ostringstream first;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; !this->Marks.empty() && cell < grid->GetNumberOfCells(); ++cell)
  {
    grid->GetCellPoints(cell, ids);
    const auto end =
      ids->begin() + GetNumberOfCorners(grid->GetCellType(cell), ids->GetNumberOfIds(), dimension);
    const auto found =
      std::find_if(ids->begin(), end, [this](vtkIdType id) { return this->Marks[id] != 0; });
    if (found == end || blanking.IsCellBlanked(cell) ||
      std::any_of(ids->begin(), end, [&](vtkIdType id) { return blanking.IsPointBlanked(id); }))
    {
      continue;
    }
    if (skipped++ == 0)
    {
      const double* x = grid->GetPoint(*found);
      first << "cell " << cell << ", with point " << *found << " at (" << x[0] << ", " << x[1]
            << ", " << x[2] << ")";
    }
  }
  return skipped == 0 ? std::string()
                      : std::to_string(skipped) +
      " cells are skipped because a corner has a NaN or infinite coordinate. The first is " +
      first.str() + ". Set finite coordinates, or blank these cells.";
}

}

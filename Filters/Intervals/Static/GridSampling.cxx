// SPDX-License-Identifier: BSD-3-Clause
#include "Static/GridSampling.h"

#include "Arrays/ExtractionArrays.h"
#include "Common/Blanking.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace interlume
{

namespace
{
/// Indices along the three axes of a grid.
using Axes = std::array<std::vector<vtkIdType>, 3>;

/// The first cell along each axis, and the number of cells along each axis.
struct CellBox
{
  std::array<vtkIdType, 3> First;
  std::array<vtkIdType, 3> Number;
};

bool HasCells(vtkDataSet* input, int dimensions[3])
{
  return input && ExtractionArrays::GetRowDimensions(input, dimensions) &&
    *std::min_element(dimensions, dimensions + 3) > 1;
}

// Returns the bounding box of the cells that are not ghost cells, or all cells if there are none.
CellBox FindOwnCells(vtkDataSet* input, const int dimensions[3])
{
  const std::array<vtkIdType, 3> cells{ { dimensions[0] - 1, dimensions[1] - 1,
    dimensions[2] - 1 } };
  const CellBox all{ {}, cells };
  Blanking blanking;
  blanking.SetBlanking(input);
  if (!blanking.CellGhosts)
  {
    return all;
  }
  std::array<vtkIdType, 3> first = cells;
  std::array<vtkIdType, 3> last{ { -1, -1, -1 } };
  for (vtkIdType cell = 0; cell < cells[0] * cells[1] * cells[2]; ++cell)
  {
    if (!blanking.IsCellDuplicate(cell))
    {
      const vtkIdType at[3] = { cell % cells[0], cell / cells[0] % cells[1],
        cell / (cells[0] * cells[1]) };
      for (int axis = 0; axis < 3; ++axis)
      {
        first[axis] = std::min(first[axis], at[axis]);
        last[axis] = std::max(last[axis], at[axis]);
      }
    }
  }
  return last[0] < 0
    ? all
    : CellBox{ first,
        { { last[0] - first[0] + 1, last[1] - first[1] + 1, last[2] - first[2] + 1 } } };
}

// Returns the ids of the points or cells with the given indices. \a sizeI and \a sizeJ are the
// numbers of points or cells along the first two axes.
vtkSmartPointer<vtkIdList> ListIds(const Axes& axes, vtkIdType sizeI, vtkIdType sizeJ)
{
  auto ids = vtkSmartPointer<vtkIdList>::New();
  ids->Allocate(static_cast<vtkIdType>(axes[0].size() * axes[1].size() * axes[2].size()));
  for (const vtkIdType k : axes[2])
  {
    for (const vtkIdType j : axes[1])
    {
      for (const vtkIdType i : axes[0])
      {
        ids->InsertNextId(i + sizeI * (j + sizeJ * k));
      }
    }
  }
  return ids;
}

void CopyArrays(vtkDataSetAttributes* from, vtkIdList* ids, vtkDataSetAttributes* to)
{
  vtkNew<vtkIdList> all;
  all->SetNumberOfIds(ids->GetNumberOfIds());
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    all->SetId(i, i);
  }
  to->CopyAllOn();
  to->CopyAllocate(from, ids->GetNumberOfIds());
  to->CopyData(from, ids, all);
}
}

vtkIdType GridSampling::CountCells(vtkDataSet* input, int stride)
{
  int dimensions[3];
  if (!HasCells(input, dimensions))
  {
    return input->GetNumberOfCells();
  }
  return std::accumulate(dimensions, dimensions + 3, vtkIdType(1),
    [stride](vtkIdType cells, int points) { return cells * ((points - 2) / stride + 1); });
}

int GridSampling::ChooseStride(const std::vector<vtkDataSet*>& leaves, vtkIdType limit)
{
  int longest = 1;
  std::vector<vtkDataSet*> grids;
  for (vtkDataSet* leaf : leaves)
  {
    int dimensions[3];
    if (HasCells(leaf, dimensions))
    {
      grids.push_back(leaf);
      longest = std::max(longest, *std::max_element(dimensions, dimensions + 3));
    }
  }
  int stride = 1;
  const auto isTooLarge = [&]
  {
    return std::accumulate(grids.begin(), grids.end(), vtkIdType(0),
             [stride](vtkIdType sum, vtkDataSet* grid)
             { return sum + CountCells(grid, stride); }) > limit;
  };
  while (stride < longest && isTooLarge())
  {
    ++stride;
  }
  return stride;
}

vtkSmartPointer<vtkDataSet> GridSampling::Sample(vtkDataSet* input, int stride)
{
  int dimensions[3];
  if (!HasCells(input, dimensions))
  {
    return nullptr;
  }
  const CellBox own = FindOwnCells(input, dimensions);
  Axes cells;
  Axes points;
  for (int axis = 0; axis < 3; ++axis)
  {
    const vtkIdType end = own.First[axis] + own.Number[axis];
    for (vtkIdType at = own.First[axis]; at < end; at += stride)
    {
      cells[axis].push_back(at);
    }
    points[axis] = cells[axis];
    points[axis].push_back(end);
  }
  auto coarse = vtkSmartPointer<vtkStructuredGrid>::New();
  coarse->SetDimensions(static_cast<int>(points[0].size()), static_cast<int>(points[1].size()),
    static_cast<int>(points[2].size()));
  const auto pointIds = ListIds(points, dimensions[0], dimensions[1]);
  vtkNew<vtkPoints> positions;
  positions->SetDataType(ExtractionArrays::ChoosePointType(input, vtkAlgorithm::DEFAULT_PRECISION));
  positions->SetNumberOfPoints(pointIds->GetNumberOfIds());
  for (vtkIdType p = 0; p < pointIds->GetNumberOfIds(); ++p)
  {
    double position[3];
    input->GetPoint(pointIds->GetId(p), position);
    positions->SetPoint(p, position);
  }
  coarse->SetPoints(positions);
  CopyArrays(input->GetPointData(), pointIds, coarse->GetPointData());
  CopyArrays(input->GetCellData(), ListIds(cells, dimensions[0] - 1, dimensions[1] - 1),
    coarse->GetCellData());
  coarse->GetFieldData()->ShallowCopy(input->GetFieldData());
  return coarse;
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/GridSample.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstdint>

namespace interlume
{

namespace
{
// Returns a cell of each group of \a stride cells.
vtkSmartPointer<vtkIdList> SelectCells(vtkUnstructuredGrid* grid, int stride)
{
  auto cells = vtkSmartPointer<vtkIdList>::New();
  for (vtkIdType first = 0; first + stride <= grid->GetNumberOfCells(); first += stride)
  {
    const std::uint64_t hash = static_cast<std::uint64_t>(first) * 0x9e3779b97f4a7c15u >> 32;
    const vtkIdType cell = first + static_cast<vtkIdType>(hash % static_cast<unsigned>(stride));
    if (grid->GetCellType(cell) == VTK_TETRA)
    {
      cells->InsertNextId(cell);
    }
  }
  return cells;
}

// Returns the tuples of \a array for \a ids, or null if there is no array.
vtkSmartPointer<vtkDataArray> CopyTuples(vtkDataArray* array, vtkIdList* ids)
{
  if (!array)
  {
    return nullptr;
  }
  auto copy = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
  copy->SetNumberOfComponents(array->GetNumberOfComponents());
  copy->SetNumberOfTuples(ids->GetNumberOfIds());
  array->GetTuples(ids, copy);
  return copy;
}
}

void GridSample::Update(vtkUnstructuredGrid* grid, const TetrahedraArrays& arrays)
{
  const vtkMTimeType time = grid->GetMTime();
  if (this->Input == grid && this->InputTime == time && this->InputArrays == arrays)
  {
    return;
  }
  this->Input = grid;
  this->InputTime = time;
  this->InputArrays = arrays;
  this->Stride = static_cast<int>(std::max<vtkIdType>(grid->GetNumberOfCells() / SIZE, 1));
  const auto cells = SelectCells(grid, this->Stride);
  vtkNew<vtkIdList> corners;
  vtkNew<vtkIdList> points;
  vtkNew<vtkCellArray> tetrahedra;
  for (vtkIdType i = 0; i < cells->GetNumberOfIds(); ++i)
  {
    grid->GetCellPoints(cells->GetId(i), corners);
    tetrahedra->InsertNextCell(4);
    for (int k = 0; k < 4; ++k)
    {
      points->InsertNextId(corners->GetId(k));
      tetrahedra->InsertCellPoint(4 * i + k);
    }
  }
  this->Grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> positions;
  positions->SetData(CopyTuples(grid->GetPoints()->GetData(), points));
  this->Grid->SetPoints(positions);
  this->Grid->SetCells(VTK_TETRA, tetrahedra);
  vtkDataArray* ghosts = grid->GetCellGhostArray();
  if (const auto copy = CopyTuples(ghosts, cells))
  {
    copy->SetName(ghosts->GetName());
    this->Grid->GetCellData()->AddArray(copy);
  }
  const auto add = [&](vtkDataArray* array, bool isOfCells)
  {
    const auto copy = CopyTuples(array, isOfCells ? cells : points);
    if (copy)
    {
      vtkDataSetAttributes* const data = isOfCells
        ? static_cast<vtkDataSetAttributes*>(this->Grid->GetCellData())
        : this->Grid->GetPointData();
      data->AddArray(copy);
    }
    return copy.Get();
  };
  this->Arrays = arrays;
  this->Arrays.Scalars = add(arrays.Scalars, arrays.HasCellScalars);
  this->Arrays.DeltaT = add(arrays.DeltaT, false);
  this->Arrays.Layers = add(arrays.Layers, true);
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/OutputPiece.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <vector>

namespace interlume
{

void OutputPiece::Extract(vtkInformation* info, vtkUnstructuredGrid* grid)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (IsEntireOutput(info))
  {
    return;
  }
  const vtkIdType pieces = info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES());
  const vtkIdType piece = info->Get(Pipeline::UPDATE_PIECE_NUMBER());
  const vtkIdType first = grid->GetNumberOfCells() * piece / pieces;
  const vtkIdType last = grid->GetNumberOfCells() * (piece + 1) / pieces;
  vtkNew<vtkIdList> corners;
  std::vector<vtkIdType> indices(static_cast<std::size_t>(grid->GetNumberOfPoints()), -1);
  for (vtkIdType cell = first; cell < last; ++cell)
  {
    grid->GetCellPoints(cell, corners);
    for (const vtkIdType corner : *corners)
    {
      indices[static_cast<std::size_t>(corner)] = 0;
    }
  }
  vtkNew<vtkIdList> usedPoints;
  vtkNew<vtkIdList> rows;
  for (vtkIdType point = 0; point < grid->GetNumberOfPoints(); ++point)
  {
    vtkIdType& index = indices[static_cast<std::size_t>(point)];
    index = index == 0 ? rows->InsertNextId(usedPoints->InsertNextId(point)) : -1;
  }
  vtkNew<vtkUnstructuredGrid> part;
  vtkNew<vtkPoints> points;
  points->SetDataType(grid->GetPoints()->GetDataType());
  grid->GetPoints()->GetPoints(usedPoints, points);
  part->SetPoints(points);
  part->GetPointData()->CopyAllOn();
  part->GetPointData()->CopyAllocate(grid->GetPointData(), usedPoints->GetNumberOfIds());
  part->GetPointData()->CopyData(grid->GetPointData(), usedPoints, rows);
  part->AllocateEstimate(last - first, 8);
  for (vtkIdType cell = first; cell < last; ++cell)
  {
    grid->GetCellPoints(cell, corners);
    for (vtkIdType& corner : *corners)
    {
      corner = indices[static_cast<std::size_t>(corner)];
    }
    part->InsertNextCell(grid->GetCellType(cell), corners);
  }
  part->GetCellData()->CopyAllOn();
  part->GetCellData()->CopyAllocate(grid->GetCellData(), last - first);
  part->GetCellData()->CopyData(grid->GetCellData(), 0, last - first, first);
  // Each grid must have its own field data object; if they shared one, copying the part back to the
  // grid would clear it.
  part->GetFieldData()->ShallowCopy(grid->GetFieldData());
  grid->ShallowCopy(part);
}

bool OutputPiece::IsEntireOutput(vtkInformation* info)
{
  return info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES()) <= 1;
}

void OutputPiece::RequestEntireInput(vtkInformation* info)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (info->Has(Pipeline::WHOLE_EXTENT()))
  {
    info->Set(Pipeline::UPDATE_EXTENT(), info->Get(Pipeline::WHOLE_EXTENT()), 6);
  }
  info->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
  info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
  info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
}

}

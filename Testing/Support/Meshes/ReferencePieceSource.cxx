// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Meshes/ReferencePieceSource.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace reference
{

namespace
{
using Pipeline = vtkStreamingDemandDrivenPipeline;

// If the dataset has an extent, calls visit(grid) with the dataset's derived type. Returns whether
// it has an extent.
template <typename Visitor>
bool VisitStructured(vtkDataSet* data, Visitor&& visit)
{
  if (vtkImageData* image = vtkImageData::SafeDownCast(data))
  {
    visit(image);
    return true;
  }
  if (vtkRectilinearGrid* grid = vtkRectilinearGrid::SafeDownCast(data))
  {
    visit(grid);
    return true;
  }
  if (vtkStructuredGrid* grid = vtkStructuredGrid::SafeDownCast(data))
  {
    visit(grid);
    return true;
  }
  return false;
}

// Returns the cells of a piece and its ghost cells, each with its ghost level.
std::vector<std::pair<vtkIdType, int>> FindCells(
  vtkDataSet* complete, int piece, int pieces, int levels)
{
  const vtkIdType number = complete->GetNumberOfCells();
  std::vector<int> levelOf(static_cast<std::size_t>(number), -1);
  std::vector<char> isNear(static_cast<std::size_t>(complete->GetNumberOfPoints()), 0);
  std::vector<std::pair<vtkIdType, int>> cells;
  vtkNew<vtkIdList> ids;
  for (int level = 0; level <= levels; ++level)
  {
    const std::size_t before = cells.size();
    for (vtkIdType cell = 0; cell < number; ++cell)
    {
      complete->GetCellPoints(cell, ids);
      const bool isInPiece =
        cell >= number * piece / pieces && cell < number * (piece + 1) / pieces;
      const bool isSelected = level == 0
        ? isInPiece
        : std::any_of(ids->begin(), ids->end(), [&](vtkIdType id) { return isNear[id] != 0; });
      if (isSelected && levelOf[cell] < 0)
      {
        levelOf[cell] = level;
        cells.emplace_back(cell, level);
      }
    }
    for (std::size_t c = before; c < cells.size(); ++c)
    {
      complete->GetCellPoints(cells[c].first, ids);
      std::for_each(ids->begin(), ids->end(), [&](vtkIdType id) { isNear[id] = 1; });
    }
  }
  return cells;
}
}

vtkStandardNewMacro(PieceSource);

PieceSource::PieceSource()
{
  this->SetNumberOfInputPorts(0);
}

PieceSource::~PieceSource() = default;

void PieceSource::SetFullData(vtkDataSet* complete)
{
  this->FullData = complete;
  this->Modified();
}

int PieceSource::RequestDataObject(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkDataObject* output = info->Get(vtkDataObject::DATA_OBJECT());
  if (!output || !output->IsA(this->FullData->GetClassName()))
  {
    const auto made = vtk::TakeSmartPointer(this->FullData->NewInstance());
    info->Set(vtkDataObject::DATA_OBJECT(), made);
  }
  return 1;
}

int PieceSource::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  const bool hasExtent = VisitStructured(this->FullData,
    [info](auto* grid)
    {
      info->Set(Pipeline::WHOLE_EXTENT(), grid->GetExtent(), 6);
      info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
    });
  if (!hasExtent)
  {
    info->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  }
  if (this->NumberOfTimeSteps > 1)
  {
    std::vector<double> times(static_cast<std::size_t>(this->NumberOfTimeSteps));
    std::generate(times.begin(), times.end(), [t = 0.0]() mutable { return t++; });
    const double range[2] = { times.front(), times.back() };
    info->Set(Pipeline::TIME_STEPS(), times.data(), this->NumberOfTimeSteps);
    info->Set(Pipeline::TIME_RANGE(), range, 2);
  }
  return 1;
}

int PieceSource::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkDataSet* output = vtkDataSet::GetData(info);
  const int ghostLevels = info->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS());
  output->ShallowCopy(this->FullData);
  const bool hasExtent = VisitStructured(output,
    [info](auto* grid)
    {
      int extent[6];
      info->Get(Pipeline::UPDATE_EXTENT(), extent);
      grid->Crop(extent);
    });
  if (!hasExtent)
  {
    output->Initialize();
    this->FillPiece(info->Get(Pipeline::UPDATE_PIECE_NUMBER()),
      std::max(1, info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES())),
      std::min(ghostLevels, this->MaximumGhostLevels), vtkUnstructuredGrid::SafeDownCast(output));
  }
  const double time =
    info->Has(Pipeline::UPDATE_TIME_STEP()) ? info->Get(Pipeline::UPDATE_TIME_STEP()) : 0.0;
  if (this->NumberOfTimeSteps > 1)
  {
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
    vtkDataArray* before = output->GetPointData()->GetScalars();
    const auto scalars = vtk::TakeSmartPointer(before->NewInstance());
    scalars->DeepCopy(before);
    for (vtkIdType id = 0; id < scalars->GetNumberOfTuples(); ++id)
    {
      scalars->SetComponent(id, 0, before->GetComponent(id, 0) + this->Change * time);
    }
    output->GetPointData()->SetScalars(scalars);
  }
  return 1;
}

void PieceSource::FillPiece(int piece, int pieces, int levels, vtkUnstructuredGrid* part) const
{
  vtkUnstructuredGrid* complete = vtkUnstructuredGrid::SafeDownCast(this->FullData);
  const auto cells = FindCells(complete, piece, pieces, levels);
  // If there is only one piece, the order of the points is kept.
  std::vector<vtkIdType> idOf(static_cast<std::size_t>(complete->GetNumberOfPoints()), -1);
  std::vector<vtkIdType> points;
  const auto number = [&](vtkIdType id)
  {
    if (idOf[id] < 0)
    {
      idOf[id] = static_cast<vtkIdType>(points.size());
      points.push_back(id);
    }
  };
  vtkNew<vtkIdList> ids;
  if (pieces == 1)
  {
    for (vtkIdType id = 0; id < complete->GetNumberOfPoints(); ++id)
    {
      number(id);
    }
  }
  for (auto cell = cells.rbegin(); cell != cells.rend(); ++cell)
  {
    complete->GetCellPoints(cell->first, ids);
    std::for_each(ids->begin(), ids->end(), number);
  }
  const auto numberOfPoints = static_cast<vtkIdType>(points.size());
  vtkNew<vtkPoints> coordinates;
  coordinates->SetDataType(complete->GetPoints()->GetDataType());
  coordinates->SetNumberOfPoints(numberOfPoints);
  vtkNew<vtkIdTypeArray> globalIds;
  globalIds->SetName("GlobalIds");
  globalIds->SetNumberOfValues(numberOfPoints);
  part->GetPointData()->CopyAllocate(complete->GetPointData(), numberOfPoints);
  for (vtkIdType id = 0; id < numberOfPoints; ++id)
  {
    coordinates->SetPoint(id, complete->GetPoint(points[id]));
    globalIds->SetValue(id, points[id]);
    part->GetPointData()->CopyData(complete->GetPointData(), points[id], id);
  }
  part->SetPoints(coordinates);
  part->GetPointData()->SetGlobalIds(globalIds);
  part->Allocate(static_cast<vtkIdType>(cells.size()));
  part->GetCellData()->CopyAllocate(complete->GetCellData(), static_cast<vtkIdType>(cells.size()));
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (const auto& cell : cells)
  {
    if (complete->GetCellType(cell.first) == VTK_POLYHEDRON)
    {
      complete->GetFaceStream(cell.first, ids);
      // The stream has the number of faces, then for each face the number of points and their ids.
      for (vtkIdType* id = ids->begin() + 1; id < ids->end(); id += 1 + *id)
      {
        std::transform(id + 1, id + 1 + *id, id + 1, [&](vtkIdType p) { return idOf[p]; });
      }
    }
    else
    {
      complete->GetCellPoints(cell.first, ids);
      std::transform(ids->begin(), ids->end(), ids->begin(), [&](vtkIdType p) { return idOf[p]; });
    }
    const vtkIdType made = part->InsertNextCell(complete->GetCellType(cell.first), ids);
    part->GetCellData()->CopyData(complete->GetCellData(), cell.first, made);
    ghosts->InsertNextValue(cell.second > 0 ? vtkDataSetAttributes::DUPLICATECELL : 0);
  }
  if (levels > 0)
  {
    part->GetCellData()->AddArray(ghosts);
  }
}

}

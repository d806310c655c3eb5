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

// Calls visit(grid) with the dataset as the kind of rows that it is; returns whether it has rows.
template <typename Visitor>
bool VisitRows(vtkDataSet* data, Visitor&& visit)
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

// The cells of a piece, then those around them, with the level of each.
std::vector<std::pair<vtkIdType, int>> FindCells(
  vtkDataSet* whole, int piece, int pieces, int levels)
{
  const vtkIdType number = whole->GetNumberOfCells();
  std::vector<int> levelOf(static_cast<std::size_t>(number), -1);
  std::vector<char> isNear(static_cast<std::size_t>(whole->GetNumberOfPoints()), 0);
  std::vector<std::pair<vtkIdType, int>> cells;
  vtkNew<vtkIdList> ids;
  for (int level = 0; level <= levels; ++level)
  {
    const std::size_t before = cells.size();
    for (vtkIdType cell = 0; cell < number; ++cell)
    {
      whole->GetCellPoints(cell, ids);
      const bool isOwn = cell >= number * piece / pieces && cell < number * (piece + 1) / pieces;
      const bool isTaken = level == 0
        ? isOwn
        : std::any_of(ids->begin(), ids->end(), [&](vtkIdType id) { return isNear[id] != 0; });
      if (isTaken && levelOf[cell] < 0)
      {
        levelOf[cell] = level;
        cells.emplace_back(cell, level);
      }
    }
    for (std::size_t c = before; c < cells.size(); ++c)
    {
      whole->GetCellPoints(cells[c].first, ids);
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

void PieceSource::SetWhole(vtkDataSet* whole)
{
  this->Whole = whole;
  this->Modified();
}

int PieceSource::RequestDataObject(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkDataObject* output = info->Get(vtkDataObject::DATA_OBJECT());
  if (!output || !output->IsA(this->Whole->GetClassName()))
  {
    const auto made = vtk::TakeSmartPointer(this->Whole->NewInstance());
    info->Set(vtkDataObject::DATA_OBJECT(), made);
  }
  return 1;
}

int PieceSource::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  const bool hasRows = VisitRows(this->Whole,
    [info](auto* grid)
    {
      info->Set(Pipeline::WHOLE_EXTENT(), grid->GetExtent(), 6);
      info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
    });
  if (!hasRows)
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
  const int asked = info->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS());
  output->ShallowCopy(this->Whole);
  const bool hasRows = VisitRows(output,
    [info](auto* grid)
    {
      int extent[6];
      info->Get(Pipeline::UPDATE_EXTENT(), extent);
      grid->Crop(extent);
    });
  if (!hasRows)
  {
    output->Initialize();
    this->FillPiece(info->Get(Pipeline::UPDATE_PIECE_NUMBER()),
      std::max(1, info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES())),
      std::min(asked, this->MaximumGhostLevels), vtkUnstructuredGrid::SafeDownCast(output));
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
  vtkUnstructuredGrid* whole = vtkUnstructuredGrid::SafeDownCast(this->Whole);
  const auto cells = FindCells(whole, piece, pieces, levels);
  // A single piece is the whole as it is.
  std::vector<vtkIdType> idOf(static_cast<std::size_t>(whole->GetNumberOfPoints()), -1);
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
    for (vtkIdType id = 0; id < whole->GetNumberOfPoints(); ++id)
    {
      number(id);
    }
  }
  for (auto cell = cells.rbegin(); cell != cells.rend(); ++cell)
  {
    whole->GetCellPoints(cell->first, ids);
    std::for_each(ids->begin(), ids->end(), number);
  }
  const auto numberOfPoints = static_cast<vtkIdType>(points.size());
  vtkNew<vtkPoints> places;
  places->SetDataType(whole->GetPoints()->GetDataType());
  places->SetNumberOfPoints(numberOfPoints);
  vtkNew<vtkIdTypeArray> globalIds;
  globalIds->SetName("GlobalIds");
  globalIds->SetNumberOfValues(numberOfPoints);
  part->GetPointData()->CopyAllocate(whole->GetPointData(), numberOfPoints);
  for (vtkIdType id = 0; id < numberOfPoints; ++id)
  {
    places->SetPoint(id, whole->GetPoint(points[id]));
    globalIds->SetValue(id, points[id]);
    part->GetPointData()->CopyData(whole->GetPointData(), points[id], id);
  }
  part->SetPoints(places);
  part->GetPointData()->SetGlobalIds(globalIds);
  part->Allocate(static_cast<vtkIdType>(cells.size()));
  part->GetCellData()->CopyAllocate(whole->GetCellData(), static_cast<vtkIdType>(cells.size()));
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (const auto& cell : cells)
  {
    if (whole->GetCellType(cell.first) == VTK_POLYHEDRON)
    {
      whole->GetFaceStream(cell.first, ids);
      // The number of faces, then of each the number of points before them.
      for (vtkIdType* id = ids->begin() + 1; id < ids->end(); id += 1 + *id)
      {
        std::transform(id + 1, id + 1 + *id, id + 1, [&](vtkIdType p) { return idOf[p]; });
      }
    }
    else
    {
      whole->GetCellPoints(cell.first, ids);
      std::transform(ids->begin(), ids->end(), ids->begin(), [&](vtkIdType p) { return idOf[p]; });
    }
    const vtkIdType made = part->InsertNextCell(whole->GetCellType(cell.first), ids);
    part->GetCellData()->CopyData(whole->GetCellData(), cell.first, made);
    ghosts->InsertNextValue(cell.second > 0 ? vtkDataSetAttributes::DUPLICATECELL : 0);
  }
  if (levels > 0)
  {
    part->GetCellData()->AddArray(ghosts);
  }
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/VolumeExtraction.h"

#include "Common/ParallelFor.h"
#include "Samples/ImplicitFlowArrays.h"
#include "Volumes/FlowVolumeReport.h"
#include "Volumes/ParameterSeams.h"
#include "Volumes/SurfaceLevels.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkFlowStatus.h"
#include "vtkIntArray.h"
#include "vtkIntervalVolume.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <limits>

namespace interlume
{

namespace
{
// Progress at the end of each stage.
constexpr double PreparationEnd = 0.1;
constexpr double InflowEnd = 0.5;
constexpr double TimeEnd = 0.85;

// Forwards progress from an inner filter to its owner, and an abort from the owner to the filter.
struct Progress
{
  vtkAlgorithm* Owner;
  double Start;
  double Length;

  static void Forward(vtkObject* caller, unsigned long, void* client, void* data)
  {
    const auto* progress = static_cast<Progress*>(client);
    progress->Owner->UpdateProgress(
      progress->Start + progress->Length * *static_cast<double*>(data));
    if (progress->Owner->GetAbortExecute())
    {
      vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
    }
  }
};

// Returns the seams across which values may be interpolated: seams where Inflow is continuous, or
// all seams if there is no Inflow.
InterpolableCells::Continuity GetContinuity(vtkDataSet* input, const ImplicitFlowArrays& arrays)
{
  return input->GetPointData()->GetArray(vtkFlowStatus::InflowArray())
    ? ImplicitFlowArrays::ReadFlags(input, vtkFlowStatus::InflowPeriodicArray())
    : arrays.GetSurfaces();
}

// Returns a shallow copy of an integer cell array of \a mesh with another name.
vtkSmartPointer<vtkIntArray> CopyAs(
  vtkUnstructuredGrid* mesh, const char* before, const char* after)
{
  vtkSmartPointer<vtkIntArray> renamed = vtkSmartPointer<vtkIntArray>::New();
  if (vtkDataArray* array = mesh->GetCellData()->GetArray(before))
  {
    renamed->ShallowCopy(array);
  }
  renamed->SetName(after);
  return renamed;
}

// Returns the OutputPointsPrecision with which an extraction from an unstructured grid has the same
// point precision as an extraction from the input.
int GetPrecision(const VolumeExtraction::Request& request)
{
  const bool hasOwnPoints = vtkPointSet::SafeDownCast(request.Input) ||
    request.OutputPointsPrecision != vtkAlgorithm::DEFAULT_PRECISION;
  return hasOwnPoints ? request.OutputPointsPrecision
                      : static_cast<int>(vtkAlgorithm::SINGLE_PRECISION);
}
}

VolumeExtraction::VolumeExtraction()
{
  this->ByInflow.Filter->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkFlowStatus::InflowArray());
  this->ByTime.Filter->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkFlowStatus::TimeArray());
  // An extraction may be empty, for example if the input is one of several pieces.
  // vtkFlowVolume issues its own warnings.
  for (vtkIntervalVolume* filter : { this->ByInflow.Filter.Get(), this->ByTime.Filter.Get() })
  {
    filter->SetSurfaceCells(vtkIntervalVolume::NEVER);
    filter->WarnOnEmptyOutputOff();
    filter->SetSizeWarningLimit(0);
  }
}

VolumeExtraction::~VolumeExtraction() = default;

bool VolumeExtraction::Prepare(const Request& request, FlowVolumeReport& report)
{
  vtkDataSet* input = request.Input;
  const bool isKnown = this->PreparedInput == input && this->PreparedTime == input->GetMTime() &&
    this->PreparedTimeJump == request.MaximumTimeJump;
  if (!isKnown)
  {
    this->PreparedInput = nullptr;
    const InterpolableCells::Limits limits{ GetContinuity(input, *request.Arrays),
      request.MaximumTimeJump };
    if (!this->Cells.Find(input, *request.Arrays, limits, request.Owner, 0.0, PreparationEnd))
    {
      return false;
    }
    this->Prepared.TakeReference(input->NewInstance());
    this->Prepared->ShallowCopy(input);
    // The status is the same in all remaining cells.
    this->Prepared->GetPointData()->RemoveArray(vtkFlowStatus::StatusArray());
    // TerminationSide must not be interpolated between samples.
    this->Prepared->GetPointData()->RemoveArray(vtkFlowStatus::SideArray());
    if (this->Cells.Count(InterpolableCells::EXCLUDED) > 0)
    {
      vtkUnsignedCharArray* before = input->GetCellGhostArray();
      vtkNew<vtkUnsignedCharArray> ghosts;
      ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
      ghosts->SetNumberOfValues(this->Cells.GetNumberOfCells());
      ParallelFor(0, this->Cells.GetNumberOfCells(),
        [&](vtkIdType cell)
        {
          const bool isHidden = this->Cells.GetKind(cell) & InterpolableCells::EXCLUDED;
          const int own = isHidden ? vtkDataSetAttributes::HIDDENCELL : 0;
          ghosts->SetValue(
            cell, static_cast<unsigned char>(own | (before ? before->GetValue(cell) : 0)));
        });
      this->Prepared->GetCellData()->AddArray(ghosts);
    }
    this->NumberOfCutCells = this->Cuts.Prepare(input, *request.Arrays, this->Cells, limits);
    this->PreparedInput = input;
    this->PreparedTime = input->GetMTime();
    this->PreparedTimeJump = request.MaximumTimeJump;
    report.Preparations = 1;
  }
  report.Cells = this->Cells.GetNumberOfCells();
  report.CellsWithoutResult = this->Cells.Count(InterpolableCells::WITHOUT_RESULT);
  report.CellsBetweenSurfaces = this->Cells.Count(InterpolableCells::BETWEEN_SURFACES);
  report.CellsOnSeams = this->Cells.Count(InterpolableCells::ON_SEAM);
  report.CellsAcrossSurfaces = this->Cells.Count(InterpolableCells::ACROSS_SURFACE);
  report.CellsWithTimeJumps = this->Cells.Count(InterpolableCells::TIME_JUMP);
  report.CellsCut = this->NumberOfCutCells;
  report.CellsAcrossSeams = this->Cells.Count(InterpolableCells::ACROSS);
  report.CellsAroundPoles = this->Cells.Count(InterpolableCells::AROUND_POLE);
  return true;
}

bool VolumeExtraction::Run(const Request& request, Result& result, vtkDataSet* input,
  const SurfaceLevels& levels, bool isFirst, double start, double end, int& passes)
{
  vtkIntervalVolume* filter = result.Filter;
  filter->SetInputDataObject(input);
  filter->SetOutputPointsPrecision(request.OutputPointsPrecision);
  levels.SetItems(filter);
  Progress progress{ request.Owner, start, end - start };
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(Progress::Forward);
  command->SetClientData(&progress);
  const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, command);
  filter->Update();
  filter->RemoveObserver(tag);
  if (filter->GetAbortExecute() || request.Owner->GetAbortExecute())
  {
    filter->SetAbortExecute(0);
    filter->Modified();
    return false;
  }
  if (result.UpdateTime == filter->GetOutput()->GetUpdateTime())
  {
    return true;
  }
  result.UpdateTime = filter->GetOutput()->GetUpdateTime();
  ++passes;
  result.Mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
  result.Mesh->ShallowCopy(filter->GetOutput());
  result.Boundary = vtkSmartPointer<vtkUnstructuredGrid>::New();
  result.Boundary->ShallowCopy(filter->GetOutput(1));
  result.PointsOnSeams = isFirst && this->Cells.Count(InterpolableCells::ACROSS) > 0
    ? ParameterSeams::Unwrap(this->Cells, *request.Arrays, result.Mesh, result.Boundary)
    : 0;
  result.CutTriangles = SurfaceTriangles();
  if (isFirst && !this->Cuts.IsEmpty())
  {
    interlume::SurfaceCuts::Request cut;
    cut.Scalars =
      &result == &this->ByInflow ? vtkFlowStatus::InflowArray() : vtkFlowStatus::TimeArray();
    cut.Levels = &levels;
    cut.Precision = GetPrecision(request);
    cut.GenerateTriangles = filter->GetGenerateBoundaries();
    result.Mesh = this->Cuts.Join(cut, result.Mesh);
    result.CutTriangles = this->Cuts.GetTriangles();
    result.PointsOnSeams += this->Cuts.GetNumberOfPointsOnSeams();
  }
  return true;
}

void VolumeExtraction::CollectTriangles(
  Result& result, const SurfaceLevels& levels, bool isFinal, SurfaceTriangles& triangles)
{
  triangles.Take(result.Boundary, levels);
  triangles.Append(result.CutTriangles);
  // Loose triangles occur only if values equal a bound. If another extraction follows, Cut()
  // removes them.
  if (isFinal && result.Filter->GetReport()->GetNumber("CollapsedSimplices") > 0)
  {
    triangles.RemoveTrianglesNotInMesh(result.Mesh);
  }
}

bool VolumeExtraction::Execute(const Request& request, FlowVolumeReport& report)
{
  if (!this->Prepare(request, report))
  {
    return false;
  }
  const bool hasOrigins = report.CellsAcrossSeams > 0 || report.CellsCut > 0;
  this->StreamTriangles = SurfaceTriangles();
  this->TimeTriangles = SurfaceTriangles();
  this->InflowItems = nullptr;
  this->TimeItems = nullptr;
  if (request.Inflow)
  {
    this->ByInflow.Filter->SetGenerateBoundaries(request.GenerateStreamSurfaces);
    this->ByInflow.Filter->SetGenerateOriginArrays(hasOrigins);
    if (!this->Run(request, this->ByInflow, this->Prepared, *request.Inflow, true, PreparationEnd,
          request.Time ? InflowEnd : TimeEnd, report.InflowPasses))
    {
      return false;
    }
    if (report.InflowPasses > 0)
    {
      this->Between = vtkSmartPointer<vtkUnstructuredGrid>::New();
      this->Between->ShallowCopy(this->ByInflow.Mesh);
      interlume::SurfaceCuts::RemoveOrigins(this->Between);
      const auto items = CopyAs(this->Between, "IntervalId", ItemArray());
      this->Between->GetCellData()->RemoveArray("IntervalId");
      this->Between->GetCellData()->AddArray(items);
    }
    this->Mesh = this->Between;
    this->InflowItems =
      vtkIntArray::SafeDownCast(this->Between->GetCellData()->GetArray(ItemArray()));
    report.PointsOnSeams = this->ByInflow.PointsOnSeams;
    if (request.GenerateStreamSurfaces)
    {
      CollectTriangles(this->ByInflow, *request.Inflow, !request.Time, this->StreamTriangles);
    }
  }
  if (!request.Time)
  {
    return true;
  }
  const bool cutsTriangles = request.Inflow && request.GenerateStreamSurfaces;
  const bool isFirst = !request.Inflow;
  this->ByTime.Filter->SetGenerateBoundaries(request.GenerateTimeSurfaces);
  this->ByTime.Filter->SetGenerateOriginArrays(cutsTriangles || (isFirst && hasOrigins));
  vtkDataSet* const input =
    request.Inflow ? static_cast<vtkDataSet*>(this->Between) : this->Prepared.GetPointer();
  if (!this->Run(request, this->ByTime, input, *request.Time, isFirst,
        request.Inflow ? InflowEnd : PreparationEnd, TimeEnd, report.TimePasses))
  {
    return false;
  }
  report.PointsOnSeams += this->ByTime.PointsOnSeams;
  if (cutsTriangles)
  {
    this->StreamTriangles.Cut(this->Between, this->ByTime.Mesh);
    report.SurfaceCuts = 1;
  }
  if (request.GenerateTimeSurfaces)
  {
    CollectTriangles(this->ByTime, *request.Time, true, this->TimeTriangles);
  }
  this->Mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
  this->Mesh->ShallowCopy(this->ByTime.Mesh);
  interlume::SurfaceCuts::RemoveOrigins(this->Mesh);
  this->TimeItems = CopyAs(this->Mesh, "IntervalId", "TimeIntervalId");
  this->InflowItems = request.Inflow
    ? vtkIntArray::SafeDownCast(this->Mesh->GetCellData()->GetArray(ItemArray()))
    : nullptr;
  return true;
}

}

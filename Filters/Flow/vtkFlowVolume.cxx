// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFlowVolume.h"

#include "Common/AbortCheck.h"
#include "Common/ArrayCheck.h"
#include "Common/Error.h"
#include "Common/GlobalIds.h"
#include "Common/GridCheck.h"
#include "Common/IntervalCheck.h"
#include "Common/NamedValue.h"
#include "Common/ParallelFor.h"
#include "Samples/FarSideSamples.h"
#include "Samples/ImplicitFlowArrays.h"
#include "Samples/OutputPiece.h"
#include "Volumes/FlowVolumeReport.h"
#include "Volumes/LevelSetNormals.h"
#include "Volumes/SurfaceLevels.h"
#include "Volumes/VolumeExtraction.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkFlowStatus.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkIntervalVolume.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkFlowVolume);

namespace
{
constexpr interlume::SurfaceLevels::Interval Everything{ { -VTK_DOUBLE_MAX, VTK_DOUBLE_MAX } };

double GetValue(const std::vector<double>& values, int i)
{
  return i >= 0 && i < static_cast<int>(values.size()) ? values[i] : 0.0;
}

interlume::Error CheckSurfaces(const std::string& name, const std::vector<double>& values)
{
  const auto found =
    std::find_if(values.begin(), values.end(), [](double value) { return !std::isfinite(value); });
  return found == values.end() ? interlume::Error()
                               : name + " surface " + std::to_string(found - values.begin()) +
      " has a value that is not finite.";
}

vtkSmartPointer<vtkIntArray> MakeIds(const char* name, vtkIntArray* items, vtkIdType number)
{
  vtkSmartPointer<vtkIntArray> ids = vtkSmartPointer<vtkIntArray>::New();
  ids->SetName(name);
  ids->SetNumberOfValues(items ? items->GetNumberOfValues() : number);
  return ids;
}

// Adds a cell array with the value \a get(item) for each cell, where item is the cell's value in \a
// items, or 0 if \a items is null.
template <typename Get>
void AddIds(vtkUnstructuredGrid* mesh, const char* name, vtkIntArray* items, const Get& get)
{
  const vtkIdType number = mesh->GetNumberOfCells();
  const auto ids = MakeIds(name, items, number);
  interlume::ParallelFor(0, number,
    [&](vtkIdType cell) { ids->SetValue(cell, get(items ? items->GetValue(cell) : 0)); });
  mesh->GetCellData()->AddArray(ids);
}

// Restores the status and id arrays, whose values must not be interpolated.
void RestorePointArrays(vtkUnstructuredGrid* mesh)
{
  const vtkIdType number = mesh->GetNumberOfPoints();
  vtkNew<vtkUnsignedCharArray> statuses;
  statuses->SetName(vtkFlowStatus::StatusArray());
  statuses->SetNumberOfValues(number);
  statuses->Fill(vtkFlowStatus::REACHED_SURFACE);
  mesh->GetPointData()->AddArray(statuses);
  vtkDataArray* before = mesh->GetPointData()->GetArray(vtkFlowStatus::IdArray());
  vtkNew<vtkIntArray> ids;
  ids->SetName(vtkFlowStatus::IdArray());
  ids->SetNumberOfValues(number);
  interlume::ParallelFor(0, before ? number : 0,
    [&](vtkIdType p) { ids->SetValue(p, static_cast<int>(before->GetComponent(p, 0))); });
  mesh->GetPointData()->AddArray(ids);
}

void FillSurface(const interlume::SurfaceTriangles& triangles, const char* name,
  vtkUnstructuredGrid* mesh, vtkUnstructuredGrid* surface)
{
  vtkNew<vtkCellArray> cells;
  const vtkIdType number = static_cast<vtkIdType>(triangles.GetTriangles().size());
  if (mesh->GetNumberOfPoints() <= VTK_INT_MAX && 3 * number <= VTK_INT_MAX)
  {
    cells->Use32BitStorage();
  }
  cells->AllocateExact(number, 3 * number);
  for (const auto& triangle : triangles.GetTriangles())
  {
    cells->InsertNextCell(3, triangle.data());
  }
  vtkNew<vtkIntArray> ids;
  ids->SetName(name);
  ids->SetNumberOfValues(number);
  std::copy(triangles.GetSurfaces().begin(), triangles.GetSurfaces().end(), ids->GetPointer(0));
  surface->SetPoints(mesh->GetPoints());
  surface->SetCells(VTK_TRIANGLE, cells);
  surface->GetPointData()->ShallowCopy(mesh->GetPointData());
  surface->GetCellData()->AddArray(ids);
}

// Makes Inflow the active scalars, or AdvectionTime if there is no Inflow.
void ChooseScalars(vtkUnstructuredGrid* output)
{
  vtkPointData* data = output->GetPointData();
  data->SetActiveScalars(data->HasArray(vtkFlowStatus::InflowArray()) ? vtkFlowStatus::InflowArray()
                                                                      : vtkFlowStatus::TimeArray());
}

// Returns the range of AdvectionTime of samples that reached a surface. If there are none, the
// lower bound is above the upper bound.
interlume::SurfaceLevels::Interval GetReachedTimes(
  vtkDataSet* input, const interlume::ImplicitFlowArrays& arrays)
{
  interlume::SurfaceLevels::Interval range{ { VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX } };
  vtkDataArray* times = input->GetPointData()->GetArray(vtkFlowStatus::TimeArray());
  for (vtkIdType p = 0; p < input->GetNumberOfPoints(); ++p)
  {
    const double time = times->GetComponent(p, 0);
    if (arrays.IsReached(p) && std::isfinite(time))
    {
      range[0] = std::min(range[0], time);
      range[1] = std::max(range[1], time);
    }
  }
  return range;
}

// Returns the range of the finite values of a point array. If there are none, the lower bound is
// above the upper bound.
interlume::SurfaceLevels::Interval GetFiniteRange(vtkDataSet* input, const char* name)
{
  interlume::SurfaceLevels::Interval range{ { VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX } };
  if (vtkDataArray* values = input->GetPointData()->GetArray(name))
  {
    values->GetFiniteRange(range.data());
  }
  return range;
}

// Returns an interval as text, such as "[1, 2]", if it lies outside a range. If they overlap,
// returns an empty string.
std::string DescribeOutside(const interlume::SurfaceLevels::Interval& interval,
  const interlume::SurfaceLevels::Interval& range)
{
  std::ostringstream text;
  if (interval[1] < range[0] || interval[0] > range[1])
  {
    text << "[" << interval[0] << ", " << interval[1] << "]";
  }
  return text.str();
}

void AddNormals(const interlume::SurfaceTriangles& triangles, const char* function,
  vtkUnstructuredGrid* mesh, vtkUnstructuredGrid* surface)
{
  surface->GetPointData()->SetNormals(interlume::LevelSetNormals::Compute(
    mesh, mesh->GetPointData()->GetArray(function), triangles.GetTriangles()));
}
}

vtkFlowVolume::vtkFlowVolume()
  : Extraction(std::make_unique<interlume::VolumeExtraction>())
{
  interlume::FlowVolumeReport().CopyTo(this->Report);
  this->SetNumberOfOutputPorts(3);
}

vtkFlowVolume::~vtkFlowVolume() = default;

void vtkFlowVolume::SetNumberOfIntervals(int number)
{
  this->Intervals.SetNumber(number, this);
}

void vtkFlowVolume::SetInterval(int i, double lower, double upper)
{
  if (const interlume::Error error = this->Intervals.Set(i, lower, upper, this))
  {
    vtkErrorMacro(<< error);
  }
}

void vtkFlowVolume::GetInterval(int i, double& lower, double& upper) const
{
  this->Intervals.Get(i, lower, upper);
}

void vtkFlowVolume::SetNumberOfSurfaces(std::vector<double>& values, int number)
{
  number = std::max(0, std::min(number, vtkIntervalList::MaximumNumber));
  if (number != static_cast<int>(values.size()))
  {
    values.resize(number, 0.0);
    this->Modified();
  }
}

void vtkFlowVolume::SetSurface(std::vector<double>& values, int i, double value)
{
  if (i < 0 || i >= vtkIntervalList::MaximumNumber)
  {
    vtkErrorMacro("Surface index " << i << " is not in the range 0 to "
                                   << vtkIntervalList::MaximumNumber - 1 << ".");
    return;
  }
  if (i >= static_cast<int>(values.size()))
  {
    this->SetNumberOfSurfaces(values, i + 1);
  }
  if (values[i] != value)
  {
    values[i] = value;
    this->Modified();
  }
}

void vtkFlowVolume::SetNumberOfStreamSurfaces(int number)
{
  this->SetNumberOfSurfaces(this->StreamSurfaces, number);
}

void vtkFlowVolume::SetStreamSurface(int i, double value)
{
  this->SetSurface(this->StreamSurfaces, i, value);
}

double vtkFlowVolume::GetStreamSurface(int i) const
{
  return GetValue(this->StreamSurfaces, i);
}

void vtkFlowVolume::SetNumberOfTimeSurfaces(int number)
{
  this->SetNumberOfSurfaces(this->TimeSurfaces, number);
}

void vtkFlowVolume::SetTimeSurface(int i, double time)
{
  this->SetSurface(this->TimeSurfaces, i, time);
}

double vtkFlowVolume::GetTimeSurface(int i) const
{
  return GetValue(this->TimeSurfaces, i);
}

int vtkFlowVolume::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkRectilinearGrid");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkStructuredGrid");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

interlume::Error vtkFlowVolume::CheckParameters(vtkDataSet* input, bool usesInflow) const
{
  using interlume::ArrayCheck::MakeSentence;
  const auto checkInflow = [&]
  {
    return MakeSentence(
      interlume::ArrayCheck::FindPointError(input, "input", vtkFlowStatus::InflowArray(), 1))
      .Within("",
        " Intervals and stream surfaces need the Inflow of vtkInflowMapping: apply that filter "
        "first, or remove them.");
  };
  interlume::Error error =
    interlume::ImplicitFlowArrays::CheckArray(input, vtkFlowStatus::TimeArray(), 1)
      .Then([&] { return MakeSentence(interlume::GridCheck::FindError(input)); })
      .Then([&] { return MakeSentence(interlume::GlobalIds::FindError(input)); })
      .Then([&] { return usesInflow ? checkInflow() : interlume::Error(); });
  for (int i = 0; !error && i < this->GetNumberOfIntervals(); ++i)
  {
    const vtkIntervalList::Interval& interval = this->Intervals.GetAll()[i];
    error = interlume::IntervalCheck::FindError(
      "Interval " + std::to_string(i), interval[0], interval[1]);
  }
  return error
    .Then(
      [&]
      {
        return interlume::IntervalCheck::FindError(
          "The time range", this->TimeRange[0], this->TimeRange[1]);
      })
    .Then([&] { return CheckSurfaces("Stream", this->StreamSurfaces); })
    .Then([&] { return CheckSurfaces("Time", this->TimeSurfaces); });
}

int vtkFlowVolume::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  interlume::FlowVolumeReport report;
  report.CopyTo(this->Report);
  vtkDataSet* input = vtkDataSet::GetData(inputs[0]);
  if (input->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  const bool usesInflow = this->GetNumberOfIntervals() > 0 || this->GetNumberOfStreamSurfaces() > 0;
  interlume::ImplicitFlowArrays arrays;
  if (const interlume::Error error =
        arrays.Find(input).Then([&] { return this->CheckParameters(input, usesInflow); }))
  {
    vtkErrorMacro(<< error);
    return 1;
  }
  const interlume::SurfaceLevels byInflow(this->GetNumberOfIntervals() > 0
      ? this->Intervals.GetAll()
      : std::vector<interlume::SurfaceLevels::Interval>{ Everything },
    this->StreamSurfaces, -VTK_DOUBLE_MAX);
  // A range that includes the largest sample time must include later times too: cells that are cut
  // at a surface have corners behind that surface.
  const bool hasLastTime = this->TimeRange[1] < VTK_DOUBLE_MAX &&
    this->TimeRange[1] >= GetFiniteRange(input, vtkFlowStatus::TimeArray())[1];
  const double end = hasLastTime ? VTK_DOUBLE_MAX : this->TimeRange[1];
  const interlume::SurfaceLevels byTime(
    { { { this->TimeRange[0], end } } }, this->TimeSurfaces, 0.0);
  const std::size_t items = std::max(byInflow.GetItems().size(), byTime.GetItems().size());
  if (items > static_cast<std::size_t>(vtkIntervalList::MaximumNumber))
  {
    vtkErrorMacro("The surfaces divide the intervals into "
      << items << " parts, more than the maximum of " << vtkIntervalList::MaximumNumber
      << ". Remove intervals or surfaces.");
    return 1;
  }
  interlume::VolumeExtraction::Request request(*this);
  this->SetProgressText("Extracting the flow volume");
  request.Input = input;
  request.Arrays = &arrays;
  request.Inflow = usesInflow ? &byInflow : nullptr;
  const bool cutsTime = byTime.GetItems().size() > 1 || byTime.GetItems()[0] != Everything;
  request.Time = cutsTime || !usesInflow ? &byTime : nullptr;
  request.GenerateTimeSurfaces = this->GenerateTimeSurfaces && cutsTime;
  request.Owner = this;
  if (!this->Extraction->Execute(request, report))
  {
    report.CopyTo(this->Report);
    return interlume::AbortCheck::Leave(outputs);
  }
  vtkUnstructuredGrid* mesh = vtkUnstructuredGrid::GetData(outputs, 0);
  this->FillMesh(byInflow, byTime, mesh);
  this->UpdateProgress(0.9);
  vtkUnstructuredGrid* streamSurfaces = vtkUnstructuredGrid::GetData(outputs, 1);
  vtkUnstructuredGrid* timeSurfaces = vtkUnstructuredGrid::GetData(outputs, 2);
  if (request.GenerateStreamSurfaces && request.Inflow)
  {
    const interlume::SurfaceTriangles& triangles = this->Extraction->GetStreamTriangles();
    FillSurface(triangles, "StreamSurfaceId", mesh, streamSurfaces);
    vtkNew<vtkDoubleArray> values;
    values->SetName(vtkFlowStatus::InflowArray());
    for (const int surface : triangles.GetSurfaces())
    {
      values->InsertNextValue(byInflow.GetValues()[surface]);
    }
    streamSurfaces->GetCellData()->AddArray(values);
    if (this->GenerateNormals)
    {
      AddNormals(triangles, vtkFlowStatus::InflowArray(), mesh, streamSurfaces);
      ++report.NormalPasses;
    }
  }
  if (request.GenerateTimeSurfaces)
  {
    const interlume::SurfaceTriangles& triangles = this->Extraction->GetTimeTriangles();
    FillSurface(triangles, "TimeSurfaceId", mesh, timeSurfaces);
    if (this->GenerateNormals)
    {
      AddNormals(triangles, vtkFlowStatus::TimeArray(), mesh, timeSurfaces);
      ++report.NormalPasses;
    }
  }
  for (vtkUnstructuredGrid* output : { mesh, streamSurfaces, timeSurfaces })
  {
    output->GetFieldData()->PassData(input->GetFieldData());
    // Far-side arrays belong to the points of the input.
    interlume::FarSideSamples::Remove(output->GetFieldData());
    ChooseScalars(output);
  }
  report.CopyTo(this->Report);
  if (interlume::OutputPiece::IsEntireOutput(outputs->GetInformationObject(0)))
  {
    const std::string warning = this->DescribeMissing(input, arrays, mesh, report);
    if (!warning.empty())
    {
      vtkWarningMacro(<< warning);
    }
  }
  return 1;
}

std::string vtkFlowVolume::DescribeMissing(vtkDataSet* input,
  const interlume::ImplicitFlowArrays& arrays, vtkUnstructuredGrid* mesh,
  const interlume::FlowVolumeReport& report) const
{
  std::ostringstream text;
  const auto name = [&text](const std::string& subject, const char* array, const auto& range)
  {
    text << subject << " outside of the range of " << array << ", [" << range[0] << ", " << range[1]
         << "]. ";
  };
  // Inflow is NaN at samples that reached no surface.
  const interlume::SurfaceLevels::Interval inflow =
    GetFiniteRange(input, vtkFlowStatus::InflowArray());
  for (int i = 0; i < this->GetNumberOfIntervals(); ++i)
  {
    const std::string outside = DescribeOutside(this->Intervals.GetAll()[i], inflow);
    if (inflow[0] <= inflow[1] && !outside.empty())
    {
      name("Interval " + std::to_string(i) + ", " + outside + ", is", vtkFlowStatus::InflowArray(),
        inflow);
    }
  }
  const bool isEmpty = mesh->GetNumberOfCells() == 0;
  const interlume::SurfaceLevels::Interval times =
    isEmpty ? GetReachedTimes(input, arrays) : interlume::SurfaceLevels::Interval{};
  if (isEmpty && times[0] <= times[1])
  {
    const std::string outside =
      DescribeOutside({ { this->TimeRange[0], this->TimeRange[1] } }, times);
    if (!outside.empty())
    {
      name("The time range, " + outside + ", is", vtkFlowStatus::TimeArray(), times);
    }
  }
  if (isEmpty && text.str().empty())
  {
    if (times[0] > times[1])
    {
      text << "None of the " << input->GetNumberOfPoints()
           << " samples reached a termination surface. ";
    }
    text << "None of the " << report.Cells
         << " cells contains part of the volume: " << report.CellsWithoutResult
         << " have corners that reached no surface, " << report.CellsBetweenSurfaces
         << " lie between surfaces, " << report.CellsOnSeams << " on seams, "
         << report.CellsAcrossSurfaces << " across their surface, " << report.CellsWithTimeJumps
         << " have jumps in time; cells of fewer than three dimensions have no volume. ";
  }
  if (this->GenerateStreamSurfaces && this->GetNumberOfIntervals() == 0 &&
    this->GetNumberOfStreamSurfaces() == 0)
  {
    text << "There is no value for stream surfaces: set StreamSurfaces or an interval. ";
  }
  std::string all = text.str();
  if (!all.empty())
  {
    all.pop_back();
  }
  return all;
}

const char* vtkFlowVolume::GetSummary()
{
  const auto count = [this](const char* name) { return this->Report->GetCount(name); };
  const vtkIdType cells = count("Cells");
  const vtkIdType cut = count("CellsCut");
  const std::pair<vtkIdType, const char*> reasons[] = {
    { count("CellsWithoutResult"), " have a corner that reached no surface" },
    { count("CellsBetweenSurfaces"), " lie between surfaces" },
    { count("CellsOnSeams"), " on seams" },
    { count("CellsAcrossSurfaces"), " across their surface" },
    { count("CellsWithTimeJumps"), " have jumps in time" }
  };
  vtkIdType special = 0;
  std::ostringstream list;
  for (const auto& reason : reasons)
  {
    special += reason.first;
    if (reason.first > 0)
    {
      list << (list.str().empty() ? " (" : ", ") << reason.first << reason.second;
    }
  }
  std::ostringstream text;
  if (cells > 0)
  {
    text << "Of " << cells << " cells, " << special - cut << " were skipped and " << cut
         << " cut at a surface or at the boundary of the flow" << list.str()
         << (special > 0 ? ")." : ".");
  }
  this->Summary = text.str();
  return this->Summary.c_str();
}

void vtkFlowVolume::FillMesh(const interlume::SurfaceLevels& byInflow,
  const interlume::SurfaceLevels& byTime, vtkUnstructuredGrid* mesh) const
{
  mesh->ShallowCopy(this->Extraction->GetMesh());
  vtkIntArray* const inflowItems = this->Extraction->GetInflowItems();
  AddIds(mesh, "IntervalId", inflowItems,
    [&](int item) { return inflowItems ? byInflow.GetInterval(item) : 0; });
  AddIds(mesh, "TimeIntervalId", this->Extraction->GetTimeItems(),
    [&](int item) { return byTime.GetSurface(item, vtkIntervalVolume::LOWER_SIDE); });
  mesh->GetCellData()->RemoveArray(interlume::VolumeExtraction::ItemArray());
  RestorePointArrays(mesh);
  if (this->ParametersAsTextureCoordinates)
  {
    mesh->GetPointData()->SetActiveTCoords(vtkFlowStatus::ParametersArray());
  }
}

void vtkFlowVolume::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->Intervals.Print(os, indent);
  os << indent << "TimeRange: " << this->TimeRange[0] << " to " << this->TimeRange[1] << "\n";
  interlume::NamedValue::Print(os, indent,
    { { "MaximumTimeJump", this->MaximumTimeJump }, { "StreamSurfaces", this->StreamSurfaces },
      { "TimeSurfaces", this->TimeSurfaces },
      { "GenerateStreamSurfaces", this->GenerateStreamSurfaces },
      { "GenerateTimeSurfaces", this->GenerateTimeSurfaces },
      { "GenerateNormals", this->GenerateNormals },
      { "ParametersAsTextureCoordinates", this->ParametersAsTextureCoordinates },
      { "OutputPointsPrecision", this->OutputPointsPrecision } });
  os << indent << "Report:\n";
  this->Report->PrintSelf(os, indent.GetNextIndent());
}

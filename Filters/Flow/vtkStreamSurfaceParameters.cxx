// SPDX-License-Identifier: BSD-3-Clause
#include "vtkStreamSurfaceParameters.h"

#include "Common/Batches.h"
#include "Common/Error.h"
#include "Common/NamedValue.h"
#include "Common/ReportValue.h"
#include "Common/Vectors.h"
#include "Fields/PointCopies.h"
#include "Samples/OutputPiece.h"
#include "Surfaces/ContourArc.h"
#include "Surfaces/LevelContours.h"
#include "Surfaces/StreamSurfaceTriangles.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFlowStatus.h"
#include "vtkIdTypeArray.h"
#include "vtkInflowMapping.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTerminationSurface.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

vtkStandardNewMacro(vtkStreamSurfaceParameters);

namespace
{
// Progress at the end of each stage.
constexpr double ContoursEnd = 0.3;
constexpr double LocationsEnd = 0.8;

void FillPoints(
  vtkPointSet* input, const interlume::StreamSurfaceTriangles::Points& made, vtkPolyData* output)
{
  const vtkIdType before = input->GetNumberOfPoints();
  if (before == static_cast<vtkIdType>(made.Sources.size()))
  {
    output->SetPoints(input->GetPoints());
    output->GetPointData()->ShallowCopy(input->GetPointData());
    return;
  }
  vtkNew<vtkPoints> points;
  interlume::PointCopies::Append(
    input, { made.Sources.begin() + before, made.Sources.end() }, points, output->GetPointData());
  output->SetPoints(points);
}

void AddPointNumbers(const interlume::StreamSurfaceTriangles::Points& made, vtkPointData* output)
{
  vtkNew<vtkIntArray> contours;
  contours->SetName("ContourId");
  vtkNew<vtkIdTypeArray> sources;
  sources->SetName("vtkOriginalPointIds");
  for (std::size_t p = 0; p < made.Sources.size(); ++p)
  {
    contours->InsertNextValue(made.Contours[p]);
    sources->InsertNextValue(made.Sources[p]);
  }
  output->AddArray(contours);
  output->AddArray(sources);
}

void AddContours(
  const std::vector<interlume::StreamSurfaceTriangles::Contour>& contours, vtkFieldData* output)
{
  vtkNew<vtkDoubleArray> lengths;
  lengths->SetName("ContourLength");
  vtkNew<vtkIntArray> closed;
  closed->SetName("ContourClosed");
  for (const interlume::StreamSurfaceTriangles::Contour& contour : contours)
  {
    lengths->InsertNextValue(contour.Length);
    closed->InsertNextValue(contour.IsClosed);
  }
  output->AddArray(lengths);
  output->AddArray(closed);
}

void SetParametersReport(vtkInterlumeReport* report, vtkIdType contours = 0,
  vtkIdType closedContours = 0, vtkIdType addedPoints = 0)
{
  interlume::ReportValue::Set(report,
    { { "Contours", contours }, { "ClosedContours", closedContours },
      { "AddedPoints", addedPoints } });
}
}

vtkStreamSurfaceParameters::vtkStreamSurfaceParameters()
{
  SetParametersReport(this->Report);
}

vtkStreamSurfaceParameters::~vtkStreamSurfaceParameters() = default;

vtkCxxSetSmartPointerMacro(vtkStreamSurfaceParameters, Mapping, vtkInflowMapping);

vtkInflowMapping* vtkStreamSurfaceParameters::GetMapping() const
{
  return this->Mapping;
}

void vtkStreamSurfaceParameters::AddTerminationSurface(vtkTerminationSurface* surface, int id)
{
  if (surface)
  {
    this->Surfaces.push_back({ surface, id });
    this->Modified();
  }
}

void vtkStreamSurfaceParameters::RemoveAllTerminationSurfaces()
{
  if (!this->Surfaces.empty())
  {
    this->Surfaces.clear();
    this->Modified();
  }
}

vtkTerminationSurface* vtkStreamSurfaceParameters::GetTerminationSurface(int i) const
{
  return i >= 0 && i < this->GetNumberOfTerminationSurfaces() ? this->Surfaces[i].Shape.GetPointer()
                                                              : nullptr;
}

void vtkStreamSurfaceParameters::AddStartPoint(double x, double y, double z)
{
  this->StartPoints.push_back({ { x, y, z } });
  this->Modified();
}

void vtkStreamSurfaceParameters::RemoveAllStartPoints()
{
  if (!this->StartPoints.empty())
  {
    this->StartPoints.clear();
    this->Modified();
  }
}

vtkMTimeType vtkStreamSurfaceParameters::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  time = this->Mapping ? std::max(time, this->Mapping->GetMTime()) : time;
  for (const Surface& surface : this->Surfaces)
  {
    time = std::max(time, surface.Shape->GetMTime());
  }
  return time;
}

int vtkStreamSurfaceParameters::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

vtkTerminationSurface* vtkStreamSurfaceParameters::FindSurface(int id, int& part) const
{
  for (const Surface& surface : this->Surfaces)
  {
    const int first = surface.Id >= 0 ? surface.Id : surface.Shape->GetId();
    if (first >= 0 && id >= first && id - first < surface.Shape->GetNumberOfParts())
    {
      part = id - first;
      return surface.Shape;
    }
  }
  return nullptr;
}

interlume::Error vtkStreamSurfaceParameters::FindContours(
  interlume::StreamSurfaceTriangles& work) const
{
  // Sorts the levels by id, so that the mapping of each id is sampled only once.
  std::vector<interlume::StreamSurfaceTriangles::Level*> order;
  for (interlume::StreamSurfaceTriangles::Level& level : work.Levels)
  {
    order.push_back(&level);
  }
  std::sort(order.begin(), order.end(),
    [](const interlume::StreamSurfaceTriangles::Level* a,
      const interlume::StreamSurfaceTriangles::Level* b)
    { return std::make_pair(a->Id, a->Value) < std::make_pair(b->Id, b->Value); });
  int id = -1;
  std::unique_ptr<interlume::LevelContours> follower;
  std::array<bool, 2> isJoined{};
  for (interlume::StreamSurfaceTriangles::Level* level : order)
  {
    int part = 0;
    vtkTerminationSurface* surface = this->FindSurface(level->Id, part);
    if (!surface)
    {
      return "There is no termination surface with id " + std::to_string(level->Id) +
        ". Call AddTerminationSurface.";
    }
    if (!follower || id != level->Id)
    {
      id = level->Id;
      if (const interlume::Error error = surface->Update())
      {
        return error.Within(
          "The termination surface with id " + std::to_string(id) + " cannot be used: ", ".");
      }
      const std::array<bool, 2> isPeriodic = work.GetArrays().GetPeriodicity(id);
      isJoined = { { this->Mapping->IsContinued(id, 0, isPeriodic[0], isPeriodic[1]),
        this->Mapping->IsContinued(id, 1, isPeriodic[0], isPeriodic[1]) } };
      follower =
        std::make_unique<interlume::LevelContours>([this, id, isPeriodic](double u, double v)
          { return this->Mapping->Evaluate(id, u, v, isPeriodic[0], isPeriodic[1]); },
          this->Resolution, isJoined);
    }
    level->FirstContour = static_cast<int>(work.Contours.size());
    std::vector<interlume::ContourLocator::Curve> curves;
    std::vector<glm::dvec3> startPoints;
    std::transform(this->StartPoints.begin(), this->StartPoints.end(),
      std::back_inserter(startPoints),
      [](const auto& point) { return glm::make_vec3(point.data()); });
    for (interlume::LevelContours::Contour& contour : follower->Follow(level->Value))
    {
      for (interlume::ContourArc& arc :
        interlume::ContourArc::Measure(std::move(contour), *surface, part, isJoined, startPoints))
      {
        work.Contours.push_back({ arc.GetLength(), arc.IsClosed });
        curves.push_back(std::move(arc.Curve));
      }
    }
    level->Locator = std::make_unique<interlume::ContourLocator>(std::move(curves), isJoined);
  }
  return {};
}

int vtkStreamSurfaceParameters::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPointSet* input = vtkPointSet::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  SetParametersReport(this->Report);
  if (input->GetNumberOfCells() == 0)
  {
    if (interlume::OutputPiece::IsEntireOutput(outputs->GetInformationObject(0)))
    {
      vtkWarningMacro(
        "The input has no triangles. Turn on GenerateStreamSurfaces of Flow Volume, connect its "
        "output Stream Surfaces (port 1), and select intervals or StreamSurfaces inside the range "
        "of Inflow.");
    }
    return 1;
  }
  this->SetProgressText("Tracing the contours of the inflow");
  interlume::StreamSurfaceTriangles work;
  interlume::Error error =
    this->Mapping ? work.Read(input) : "There is no mapping. Call SetMapping.";
  error = error.Then([&] { return this->FindContours(work); });
  if (error)
  {
    vtkErrorMacro(<< error);
    return 1;
  }
  const auto locate = [&](vtkIdType first, vtkIdType last)
  {
    for (vtkIdType p = first; p < last; ++p)
    {
      work.Locate(p);
    }
  };
  if (!interlume::Batches::Run(input->GetNumberOfPoints(), this, ContoursEnd, LocationsEnd, locate))
  {
    return 1;
  }
  vtkNew<vtkCellArray> cells;
  const interlume::StreamSurfaceTriangles::Points made = work.MakeTriangles(cells);
  FillPoints(input, made, output);
  output->SetPolys(cells);
  output->GetCellData()->ShallowCopy(input->GetCellData());
  this->FillTexture(made.Lengths, made.Sources,
    input->GetPointData()->GetArray(vtkFlowStatus::TimeArray()), output);
  AddPointNumbers(made, output->GetPointData());
  output->GetFieldData()->PassData(input->GetFieldData());
  AddContours(work.Contours, output->GetFieldData());
  SetParametersReport(this->Report, static_cast<vtkIdType>(work.Contours.size()),
    std::count_if(work.Contours.begin(), work.Contours.end(),
      [](const auto& contour) { return contour.IsClosed; }),
    output->GetNumberOfPoints() - input->GetNumberOfPoints());
  output->GetPointData()->SetActiveScalars(vtkFlowStatus::TimeArray());
  return 1;
}

void vtkStreamSurfaceParameters::FillTexture(const std::vector<double>& lengths,
  const std::vector<vtkIdType>& sources, vtkDataArray* times, vtkPolyData* output) const
{
  vtkNew<vtkDoubleArray> texture;
  texture->SetName("StreamTexture");
  texture->SetNumberOfComponents(2);
  texture->SetNumberOfTuples(static_cast<vtkIdType>(lengths.size()));
  for (std::size_t p = 0; p < lengths.size(); ++p)
  {
    texture->SetTuple2(static_cast<vtkIdType>(p), this->LengthScale * lengths[p],
      this->TimeScale * times->GetComponent(sources[p], 0));
  }
  output->GetPointData()->SetTCoords(texture);
}

void vtkStreamSurfaceParameters::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::NamedValue::Print(os, indent,
    { { "Mapping", this->Mapping ? "set" : "none" },
      { "TerminationSurfaces", this->Surfaces.size() }, { "StartPoints", this->StartPoints.size() },
      { "LengthScale", this->LengthScale }, { "TimeScale", this->TimeScale },
      { "Resolution", this->Resolution } });
  os << indent << "Report:\n";
  this->Report->PrintSelf(os, indent.GetNextIndent());
}

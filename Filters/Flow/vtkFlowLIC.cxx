// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFlowLIC.h"

#include "Common/AbortCheck.h"
#include "Common/Batches.h"
#include "Common/CellArrayConversion.h"
#include "Common/Error.h"
#include "Common/NamedValue.h"
#include "Common/Vectors.h"
#include "Convolution/ArcWalk.h"
#include "Convolution/ConvolutionKernel.h"
#include "Convolution/FlowLICReport.h"
#include "Convolution/LatticeNoise.h"
#include "Convolution/SurfaceRefinement.h"
#include "Fields/FieldDispatch.h"
#include "Fields/FieldVectors.h"
#include "Samples/OutputPiece.h"

#include "vtkCellArray.h"
#include "vtkDataSet.h"
#include "vtkFloatArray.h"
#include "vtkGenericCell.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

vtkStandardNewMacro(vtkFlowLIC);

namespace
{
constexpr double MaximumSteps = 1e6;
constexpr double RelativeMinimumSpeed = 1e-9;
/// Maximum number of triangles that refinement adds. Convolution at their points takes two to four
/// seconds of processor time in curvilinear grids.
constexpr vtkIdType MaximumTriangles = 40000;

/// Returns the length of the diagonal of the bounds.
double GetDiagonal(vtkDataSet* data)
{
  double box[6];
  data->GetBounds(box);
  return interlume::Vectors::SafeLength({ box[1] - box[0], box[3] - box[2], box[5] - box[4] });
}

/// Returns the mean edge length of about a thousand evenly distributed cells; 0 without cells. The
/// edges of a cell are those of a box with the same dimension and diagonal.
double EstimateSpacing(vtkDataSet* points)
{
  constexpr vtkIdType number = 1000;
  const vtkIdType stride = points->GetNumberOfCells() / number + 1;
  vtkNew<vtkGenericCell> cell;
  double sum = 0.0;
  vtkIdType counted = 0;
  for (vtkIdType id = 0; id < points->GetNumberOfCells(); id += stride)
  {
    points->GetCell(id, cell);
    if (cell->GetCellDimension() > 0)
    {
      double box[6];
      cell->GetBounds(box);
      sum += interlume::Vectors::SafeLength({ box[1] - box[0], box[3] - box[2], box[5] - box[4] }) /
        std::sqrt(cell->GetCellDimension());
      ++counted;
    }
  }
  return counted > 0 ? sum / static_cast<double>(counted) : 0.0;
}

/// Returns unit normals at the points of the polygons of a surface, or 0 at other points. The sign
/// of a normal is arbitrary.
std::vector<glm::dvec3> MakeNormals(vtkDataSet* points, bool isProjected)
{
  std::vector<glm::dvec3> normals(
    static_cast<std::size_t>(points->GetNumberOfPoints()), glm::dvec3(0.0));
  auto* surface = vtkPolyData::SafeDownCast(points);
  const vtkIdType number = surface && isProjected ? surface->GetNumberOfPolys() : 0;
  for (vtkIdType cell = 0; cell < number; ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    surface->GetPolys()->GetCellAtId(cell, size, corners);
    glm::dvec3 normal;
    vtkPolygon::ComputeNormal(
      surface->GetPoints(), static_cast<int>(size), corners, glm::value_ptr(normal));
    for (vtkIdType i = 0; i < size; ++i)
    {
      glm::dvec3& sum = normals[static_cast<std::size_t>(corners[i])];
      sum += glm::dot(sum, normal) < 0.0 ? -normal : normal;
    }
  }
  for (glm::dvec3& normal : normals)
  {
    const double length = glm::length(normal);
    normal = length > 0.0 ? normal / length : glm::dvec3(0.0);
  }
  return normals;
}

/// Returns the value at \a x, with the lengths of \a report. Counts points in \a count.
template <typename Walker>
double ConvolveAt(const double x[3], const glm::dvec3& normal, interlume::ArcWalk<Walker>& walk,
  const interlume::LatticeNoise& noise, const interlume::ConvolutionKernel& kernel,
  const interlume::FlowLICReport& report, double contrast, interlume::FlowLICReport& count)
{
  if (!walk.Begin(x, normal))
  {
    ++count.PointsOutside;
    return 0.0;
  }
  count.PointsAtRest += walk.CanAdvance() ? 0 : 1;
  double sum = noise.Evaluate(x);
  int reached[2] = { 0, 0 };
  for (int side = 0; side < 2; ++side)
  {
    walk.Return();
    const double step = side == 0 ? -report.StepLength : report.StepLength;
    int& j = reached[side];
    while (j < report.Steps && walk.Advance(step))
    {
      ++j;
      sum += kernel.GetWeight(j) * noise.Evaluate(walk.GetPosition());
    }
  }
  const bool isShort = std::min(reached[0], reached[1]) < report.Steps;
  count.PointsWithShortLines += isShort && walk.CanAdvance() ? 1 : 0;
  const double mean = sum / kernel.GetSum(reached[0], reached[1]);
  const double stretched =
    0.5 + contrast * (mean - 0.5) / kernel.GetDeviation(reached[0], reached[1]);
  return std::clamp(stretched, 0.0, 1.0);
}
}

vtkFlowLIC::vtkFlowLIC()
{
  interlume::FlowLICReport().CopyTo(this->Report);
  this->SetNumberOfInputPorts(2);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::VECTORS);
}

void vtkFlowLIC::SetFieldData(vtkDataSet* field)
{
  this->SetInputDataInternal(1, field);
}

int vtkFlowLIC::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkFlowLIC::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->Superclass::RequestUpdateExtent(request, inputs, outputs);
  // Requests the whole field, because streamlines may visit all of it.
  const int port = inputs[1]->GetNumberOfInformationObjects() > 0 ? 1 : 0;
  interlume::OutputPiece::RequestEntireInput(inputs[port]->GetInformationObject(0));
  return 1;
}

interlume::Error vtkFlowLIC::FindSteps(interlume::FlowLICReport& report) const
{
  report.Length = this->Length > 0.0 ? this->Length : 10.0 * report.NoiseScale;
  const double step = this->StepLength > 0.0 ? this->StepLength : 0.25 * report.NoiseScale;
  // The factor keeps rounding from adding a step.
  const double steps = std::max(1.0, std::ceil(report.Length / step * (1.0 - 1e-12)));
  if (!(steps <= MaximumSteps))
  {
    return "Length " + std::to_string(report.Length) +
      " is more than 1,000,000 steps of StepLength. Reduce Length or increase StepLength.";
  }
  report.Steps = static_cast<int>(steps);
  report.StepLength = report.Length / steps;
  return {};
}

void vtkFlowLIC::PreparePoints(
  vtkDataSet* points, vtkDataSet* output, interlume::FlowLICReport& report) const
{
  const double diagonal = GetDiagonal(points);
  const double automatic = diagonal > 0.0 ? diagonal / 128.0 : 1.0;
  report.NoiseScale = this->NoiseScale > 0.0 ? this->NoiseScale : automatic;
  if (!this->CanRefine(points))
  {
    report.NoiseScale = this->NoiseScale > 0.0 ? this->NoiseScale
                                               : std::max(automatic, 2.0 * EstimateSpacing(points));
    output->ShallowCopy(points);
    return;
  }
  const interlume::SurfaceRefinement refinement(points);
  const double length = refinement.FindLength(
    std::max(0.5 * report.NoiseScale, std::numeric_limits<double>::min()), MaximumTriangles);
  report.NoiseScale = this->NoiseScale > 0.0 ? this->NoiseScale : 2.0 * length;
  output->ShallowCopy(refinement.Divide(length));
}

bool vtkFlowLIC::CanRefine(vtkDataSet* points) const
{
  auto* surface = vtkPolyData::SafeDownCast(points);
  return this->RefineSurface && surface &&
    surface->GetNumberOfPolys() + surface->GetNumberOfStrips() > 0;
}

int vtkFlowLIC::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  interlume::FlowLICReport report;
  report.CopyTo(this->Report);
  vtkDataSet* points = vtkDataSet::GetData(inputs[0]);
  vtkDataSet* field =
    inputs[1]->GetNumberOfInformationObjects() > 0 ? vtkDataSet::GetData(inputs[1]) : points;
  vtkDataSet* output = vtkDataSet::GetData(outputs);
  if (points->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  interlume::CellArrayConversion conversion(this, 3);
  const interlume::CellArrayConversion::Selection selection = conversion.Select(field);
  report.ConvertedCellArrays = conversion.GetNames();
  vtkDataArray* vectors = vtkDataArray::SafeDownCast(selection.Array);
  interlume::FillValues fill;
  interlume::Error error =
    interlume::FieldVectors::CheckVectors(selection, this->GetInputArrayInformation(0));
  if (!error)
  {
    this->PreparePoints(points == field ? selection.Data : points, output, report);
    error = this->FindSteps(report).Then(
      [&] { return this->ConvolveField(selection.Data, vectors, output, report, fill); });
  }
  if (error)
  {
    vtkErrorMacro(<< error);
  }
  report.CopyTo(this->Report);
  if (error || this->GetAbortExecute())
  {
    output->Initialize();
    return this->GetAbortExecute() ? interlume::AbortCheck::Leave(outputs) : 1;
  }
  if (interlume::OutputPiece::IsEntireOutput(outputs->GetInformationObject(0)))
  {
    this->Warn(selection.Data, vectors->GetName(), fill, report);
  }
  return 1;
}

interlume::Error vtkFlowLIC::ConvolveField(vtkDataSet* field, vtkDataArray* vectors,
  vtkDataSet* output, interlume::FlowLICReport& report, interlume::FillValues& fill)
{
  this->SetProgressText("Convolving noise along streamlines");
  vtkNew<vtkFloatArray> values;
  values->SetName("LIC");
  values->SetNumberOfValues(output->GetNumberOfPoints());
  const interlume::Error error = interlume::FieldDispatch::Execute(
    field, vectors, {},
    [&](const auto& walker)
    {
      fill = walker.GetField().GetFillValues();
      report.NonFiniteVectors = walker.GetField().GetNumberOfNonFiniteVectors();
      this->Convolve(walker, output, values->GetPointer(0), report);
    },
    interlume::StageProgress(this, 0.0, interlume::FieldDispatch::BuildingPart));
  report.FillValues = fill.Number;
  // SetScalars would remove the previous active scalars.
  output->GetPointData()->AddArray(values);
  output->GetPointData()->SetActiveScalars(values->GetName());
  return error;
}

void vtkFlowLIC::Warn(vtkDataSet* field, const char* vectors, const interlume::FillValues& fill,
  const interlume::FlowLICReport& report)
{
  if (fill.Number > 0)
  {
    vtkWarningMacro(<< fill.Describe(vectors,
                      "These vectors do not affect the minimum speed, but streamlines still follow "
                      "them."));
  }
  if (report.NonFiniteVectors > 0)
  {
    vtkWarningMacro(<< interlume::DescribeNonFinite(report.NonFiniteVectors, vectors,
                      "Streamlines end at cells with such points."));
  }
  if (report.PointsOutside == report.Points)
  {
    double bounds[6];
    field->GetBounds(bounds);
    vtkWarningMacro("All " << report.Points << " points lie outside the field, whose bounds are x "
                           << bounds[0] << " to " << bounds[1] << ", y " << bounds[2] << " to "
                           << bounds[3] << ", z " << bounds[4] << " to " << bounds[5]
                           << ". LIC is 0 at all of them. Pass points inside the field.");
  }
}

template <typename Walker>
void vtkFlowLIC::Convolve(
  const Walker& walker, vtkDataSet* points, float* values, interlume::FlowLICReport& report)
{
  if constexpr (std::is_same_v<Walker, interlume::UnstructuredWalker>)
  {
    this->Mesh = walker.GetField().GetMesh();
  }
  const double minimumSpeed = std::max(
    RelativeMinimumSpeed * walker.GetField().GetSpeedScale(), std::numeric_limits<double>::min());
  const interlume::LatticeNoise noise(report.NoiseScale, this->Seed);
  const interlume::ConvolutionKernel kernel(
    this->Kernel == HANN, report.Steps, report.StepLength, report.NoiseScale);
  const double contrast = this->Contrast;
  const std::vector<glm::dvec3> normals = MakeNormals(points, this->ProjectVectors);
  vtkSMPThreadLocal<interlume::FlowLICReport> counts;
  double first[3];
  // Datasets may build internal data at the first call, so it must precede calls from several
  // threads.
  points->GetPoint(0, first);
  interlume::Batches::Run(points->GetNumberOfPoints(), this, interlume::FieldDispatch::BuildingPart,
    1.0,
    [&](vtkIdType begin, vtkIdType end)
    {
      interlume::ArcWalk<Walker> walk(walker, minimumSpeed);
      for (vtkIdType id = begin; id < end; ++id)
      {
        double x[3];
        points->GetPoint(id, x);
        values[id] = static_cast<float>(ConvolveAt(x, normals[static_cast<std::size_t>(id)], walk,
          noise, kernel, report, contrast, counts.Local()));
      }
    });
  report.Points = points->GetNumberOfPoints();
  for (const interlume::FlowLICReport& count : counts)
  {
    report.PointsOutside += count.PointsOutside;
    report.PointsAtRest += count.PointsAtRest;
    report.PointsWithShortLines += count.PointsWithShortLines;
  }
}

void vtkFlowLIC::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::NamedValue::Print(os, indent,
    { { "Kernel", this->Kernel == HANN ? "Hann" : "box" }, { "Length", this->Length },
      { "NoiseScale", this->NoiseScale }, { "StepLength", this->StepLength },
      { "RefineSurface", this->RefineSurface }, { "ProjectVectors", this->ProjectVectors },
      { "Seed", this->Seed }, { "Contrast", this->Contrast } });
  os << indent << "Report:\n";
  this->Report->PrintSelf(os, indent.GetNextIndent());
}

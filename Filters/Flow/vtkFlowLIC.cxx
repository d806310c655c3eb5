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
#include "Fields/FieldDispatch.h"
#include "Fields/FieldVectors.h"
#include "Samples/OutputPiece.h"

#include "vtkAdaptiveSubdivisionFilter.h"
#include "vtkDataSet.h"
#include "vtkFloatArray.h"
#include "vtkGenericCell.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTriangle.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>

vtkStandardNewMacro(vtkFlowLIC);

namespace
{
constexpr double MaximumSteps = 1e6;
constexpr double RelativeMinimumSpeed = 1e-9;
/// Edges of a refined surface are so long that about this number of triangles covers it.
constexpr double MaximumTriangles = 2e6;

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

/// Returns the polygons of a surface as triangles with edges of at most \a length.
vtkSmartPointer<vtkPolyData> Refine(vtkDataSet* surface, double length)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputDataObject(surface);
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->Update();
  vtkPolyData* coarse = triangles->GetOutput();
  double area = 0.0;
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType id = 0; id < coarse->GetNumberOfCells(); ++id)
  {
    coarse->GetCell(id, cell);
    double corners[3][3];
    for (int i = 0; i < 3; ++i)
    {
      cell->GetPoints()->GetPoint(i, corners[i]);
    }
    area += vtkTriangle::TriangleArea(corners[0], corners[1], corners[2]);
  }
  vtkNew<vtkAdaptiveSubdivisionFilter> refined;
  refined->SetInputData(coarse);
  // A limit of the number or the area of triangles would leave holes or cracks.
  refined->SetMaximumEdgeLength(std::max(length, 2.0 * std::sqrt(area / MaximumTriangles)));
  refined->SetMaximumTriangleArea(VTK_DOUBLE_MAX);
  refined->SetMaximumNumberOfTriangles(VTK_ID_MAX);
  refined->Update();
  return refined->GetOutput();
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

interlume::Error vtkFlowLIC::FindSteps(vtkDataSet* points, interlume::FlowLICReport& report) const
{
  report.NoiseScale = this->NoiseScale;
  if (report.NoiseScale == 0.0)
  {
    double box[6];
    points->GetBounds(box);
    const double diagonal =
      interlume::Vectors::SafeLength({ box[1] - box[0], box[3] - box[2], box[5] - box[4] });
    report.NoiseScale = diagonal > 0.0 ? diagonal / 128.0 : 1.0;
    if (!this->CanRefine(points))
    {
      report.NoiseScale = std::max(report.NoiseScale, 2.0 * EstimateSpacing(points));
    }
  }
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
  points = points == field ? selection.Data : points;
  field = selection.Data;
  report.ConvertedCellArrays = conversion.GetNames();
  vtkDataArray* vectors = vtkDataArray::SafeDownCast(selection.Array);
  interlume::Error error =
    interlume::FieldVectors::CheckVectors(selection, this->GetInputArrayInformation(0));
  error = error.Then([&] { return this->FindSteps(points, report); });
  vtkSmartPointer<vtkPolyData> refined;
  if (!error && this->CanRefine(points))
  {
    refined = Refine(points, 0.5 * report.NoiseScale);
    points = refined;
  }
  output->ShallowCopy(points);
  this->SetProgressText("Convolving noise along streamlines");
  vtkNew<vtkFloatArray> values;
  interlume::FillValues fill;
  vtkIdType nonFinite = 0;
  if (!error)
  {
    values->SetName("LIC");
    values->SetNumberOfValues(points->GetNumberOfPoints());
    error = interlume::FieldDispatch::Execute(
      field, vectors, {},
      [&](const auto& walker)
      {
        fill = walker.GetField().GetFillValues();
        nonFinite = walker.GetField().GetNumberOfNonFiniteVectors();
        this->Convolve(walker, points, values->GetPointer(0), report);
      },
      interlume::StageProgress(this, 0.0, interlume::FieldDispatch::BuildingPart));
  }
  if (error)
  {
    vtkErrorMacro(<< error);
  }
  if (error || this->GetAbortExecute())
  {
    report.CopyTo(this->Report);
    output->Initialize();
    return this->GetAbortExecute() ? interlume::AbortCheck::Leave(outputs) : 1;
  }
  // SetScalars would remove the previous active scalars.
  output->GetPointData()->AddArray(values);
  output->GetPointData()->SetActiveScalars(values->GetName());
  const bool isEntireOutput =
    interlume::OutputPiece::IsEntireOutput(outputs->GetInformationObject(0));
  report.FillValues = fill.Number;
  report.NonFiniteVectors = nonFinite;
  report.CopyTo(this->Report);
  if (fill.Number > 0 && isEntireOutput)
  {
    vtkWarningMacro(<< fill.Describe(vectors->GetName(),
                      "These vectors do not affect the minimum speed, but streamlines still follow "
                      "them."));
  }
  if (nonFinite > 0 && isEntireOutput)
  {
    vtkWarningMacro(<< interlume::DescribeNonFinite(
                      nonFinite, vectors->GetName(), "Streamlines end at cells with such points."));
  }
  if (report.PointsOutside == report.Points && isEntireOutput)
  {
    double bounds[6];
    field->GetBounds(bounds);
    vtkWarningMacro("All " << report.Points << " points lie outside the field, whose bounds are x "
                           << bounds[0] << " to " << bounds[1] << ", y " << bounds[2] << " to "
                           << bounds[3] << ", z " << bounds[4] << " to " << bounds[5]
                           << ". LIC is 0 at all of them. Pass points inside the field.");
  }
  return 1;
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
      interlume::FlowLICReport& count = counts.Local();
      for (vtkIdType id = begin; id < end; ++id)
      {
        double x[3];
        points->GetPoint(id, x);
        if (!walk.IsInside(x))
        {
          ++count.PointsOutside;
          values[id] = 0.0f;
          continue;
        }
        walk.Begin(x);
        count.PointsAtRest += walk.CanAdvance() ? 0 : 1;
        double sum = noise.Evaluate(x);
        int reached[2] = { 0, 0 };
        for (int side = 0; side < 2; ++side)
        {
          walk.Begin(x);
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
        values[id] = static_cast<float>(std::clamp(stretched, 0.0, 1.0));
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
      { "RefineSurface", this->RefineSurface }, { "Seed", this->Seed },
      { "Contrast", this->Contrast } });
  os << indent << "Report:\n";
  this->Report->PrintSelf(os, indent.GetNextIndent());
}

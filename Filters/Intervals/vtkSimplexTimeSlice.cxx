// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSimplexTimeSlice.h"

#include "Arrays/ExtractionArrays.h"
#include "Arrays/PointArrays.h"
#include "Common/ReportValue.h"
#include "Pass/NonFinitePoints.h"
#include "Scalars/ExtractionDispatch.h"
#include "Scalars/ExtractionScalars.h"
#include "Static/DataSetLeaves.h"
#include "Static/EmptyOutputDiagnosis.h"
#include "Static/ExtractionInput.h"
#include "TimeVarying/SimplexSlicer.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

vtkStandardNewMacro(vtkSimplexTimeSlice);

namespace interlume
{
/// Values of vtkSimplexTimeSlice::GetReport().
struct SimplexTimeSliceReport
{
  double Time = 0.0;
  vtkIdType Simplices = 0;
  vtkIdType Tetrahedra = 0;
  vtkIdType NonFiniteSimplices = 0;

  void CopyTo(vtkInterlumeReport* report) const
  {
    ReportValue::Set(report,
      { { "Time", this->Time }, { "Simplices", this->Simplices },
        { "Tetrahedra", this->Tetrahedra }, { "NonFiniteSimplices", this->NonFiniteSimplices } });
  }
};
}

namespace
{
constexpr const char* TimeName = "Time";

// Sets the exact time. Interpolated times would have rounding errors, and a float array might not
// represent the time exactly.
void FillTime(vtkPointData* points, vtkIdType number, double time)
{
  vtkNew<vtkDoubleArray> times;
  times->SetName(TimeName);
  times->SetNumberOfValues(number);
  vtkSMPTools::Fill(times->GetPointer(0), times->GetPointer(0) + number, time);
  // AddArray replaces the interpolated array of the same name. If that was an active attribute, the
  // new array becomes the active one.
  points->AddArray(times);
}

// Sets the data time of an output to the requested time, if a time is requested.
void SetRequestedTime(vtkInformation* request, vtkDataObject* output)
{
  vtkInformationDoubleKey* key = vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP();
  if (request && request->Has(key))
  {
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), request->Get(key));
  }
}

// Returns the axis whose coordinate time replaces: that of the largest component, and TIME_AXIS if
// it is as large as the others.
int FindReplacedAxis(const std::array<double, 4>& normal)
{
  int largest = vtkSimplexTimeSlice::TIME_AXIS;
  for (int axis = 0; axis < 3; ++axis)
  {
    largest = std::abs(normal[axis]) > std::abs(normal[largest]) ? axis : largest;
  }
  return largest;
}

// Returns the positions of all points along the normal. They are NaN at times that are not finite.
vtkSmartPointer<vtkDoubleArray> MakePositions(
  vtkUnstructuredGrid* input, vtkDataArray* times, const std::array<double, 4>& normal)
{
  auto positions = vtkSmartPointer<vtkDoubleArray>::New();
  positions->SetNumberOfValues(input->GetNumberOfPoints());
  vtkSMPTools::For(0, input->GetNumberOfPoints(),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType point = first; point < last; ++point)
      {
        double x[3];
        input->GetPoint(point, x);
        const double time = times->GetComponent(point, 0);
        // Components of the normal that are zero must not multiply infinite coordinates.
        double sum = std::isfinite(time) ? 0.0 : std::numeric_limits<double>::quiet_NaN();
        for (int axis = 0; axis < 4; ++axis)
        {
          sum += normal[axis] == 0.0 ? 0.0 : normal[axis] * (axis < 3 ? x[axis] : time);
        }
        positions->SetValue(point, sum);
      }
    });
  return positions;
}

// Finds the time range of all datasets of an input. If there are no times, sets range[0] >
// range[1].
void FindTimes(vtkDataObject* input, double range[2])
{
  range[0] = std::numeric_limits<double>::infinity();
  range[1] = -std::numeric_limits<double>::infinity();
  for (vtkDataSet* leaf : interlume::DataSetLeaves::Get(input))
  {
    vtkDataArray* times = leaf ? leaf->GetPointData()->GetArray(TimeName) : nullptr;
    if (times && times->GetNumberOfComponents() == 1 && times->GetNumberOfTuples() > 0)
    {
      double leafRange[2];
      times->GetFiniteRange(leafRange, 0);
      range[0] = std::min(range[0], leafRange[0]);
      range[1] = std::max(range[1], leafRange[1]);
    }
  }
}

// Returns an error if the array `Time`, the position or the normal of the slice is invalid.
interlume::Error CheckTimes(
  vtkUnstructuredGrid* input, double position, const std::array<double, 4>& normal, bool isAtTime)
{
  interlume::Error error = interlume::ExtractionInput::CheckScalars(input,
    input->GetPointData()->GetAbstractArray(TimeName), vtkDataObject::FIELD_ASSOCIATION_POINTS,
    "point array \"Time\"");
  const double sum =
    std::abs(normal[0]) + std::abs(normal[1]) + std::abs(normal[2]) + std::abs(normal[3]);
  const bool isNormal = std::isfinite(sum) && sum > 0.0;
  if (error || (isNormal && std::isfinite(position)))
  {
    return error;
  }
  std::ostringstream message;
  if (!isNormal)
  {
    message << "The Normal (" << normal[0] << ", " << normal[1] << ", " << normal[2] << ", "
            << normal[3] << ") is zero or not finite. Set a finite Normal other than zero.";
  }
  else
  {
    message << "The " << (isAtTime ? "time" : "position") << " of the slice is " << position
            << ", which is not finite. Set a finite " << (isAtTime ? "Time." : "Position.");
  }
  return message.str();
}
}

vtkSimplexTimeSlice::vtkSimplexTimeSlice()
{
  interlume::SimplexTimeSliceReport().CopyTo(this->Report);
}

vtkSimplexTimeSlice::~vtkSimplexTimeSlice() = default;

int vtkSimplexTimeSlice::FillInputPortInformation(int, vtkInformation* info)
{
  interlume::DataSetLeaves::FillInput(info, "vtkUnstructuredGrid");
  return 1;
}

int vtkSimplexTimeSlice::FillOutputPortInformation(int, vtkInformation* info)
{
  interlume::DataSetLeaves::FillOutput(info);
  return 1;
}

vtkTypeBool vtkSimplexTimeSlice::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT())
    ? interlume::DataSetLeaves::RequestDataObject(inputs, outputs)
    : this->Superclass::ProcessRequest(request, inputs, outputs);
}

int vtkSimplexTimeSlice::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* output = outputs->GetInformationObject(0);
  output->Remove(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
  output->Remove(vtkStreamingDemandDrivenPipeline::TIME_RANGE());
  if (this->FollowTime && this->IsAtTime())
  {
    // Without a time range, the pipeline would not execute again when another time is requested.
    double range[2];
    FindTimes(vtkDataObject::GetData(inputs[0]), range);
    if (range[0] > range[1])
    {
      range[0] = -std::numeric_limits<double>::max();
      range[1] = std::numeric_limits<double>::max();
    }
    output->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
  }
  return 1;
}

std::array<double, 4> vtkSimplexTimeSlice::MakeNormal() const
{
  std::array<double, 4> normal{};
  if (this->SliceAxis == HYPERPLANE)
  {
    std::copy_n(this->Normal, 4, normal.begin());
  }
  else
  {
    normal[this->SliceAxis] = 1.0;
  }
  return normal;
}

double vtkSimplexTimeSlice::GetPositionOfSlice(vtkInformation* output) const
{
  if (!this->IsAtTime())
  {
    return this->Position;
  }
  vtkInformationDoubleKey* requested = vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP();
  if (!this->FollowTime || !output->Has(requested) || this->InputRange[0] > this->InputRange[1])
  {
    return this->Time;
  }
  return std::max(this->InputRange[0], std::min(output->Get(requested), this->InputRange[1]));
}

int vtkSimplexTimeSlice::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (this->IsAtTime())
  {
    FindTimes(vtkDataObject::GetData(inputs[0]), this->InputRange);
  }
  else
  {
    this->InputRange[0] = std::numeric_limits<double>::infinity();
    this->InputRange[1] = -std::numeric_limits<double>::infinity();
  }
  vtkInformation* info = outputs->GetInformationObject(0);
  interlume::SimplexTimeSliceReport report;
  report.Time = this->GetPositionOfSlice(info);
  this->SetProgressText("Cutting the 4-simplices");
  vtkInformation* request = this->FollowTime && this->IsAtTime() ? info : nullptr;
  interlume::EmptyOutputDiagnosis empty;
  interlume::DataSetLeaves::ForEach(this, inputs, outputs,
    [&](vtkDataSet* input, const std::vector<vtkUnstructuredGrid*>& grids)
    { this->Slice(input, request, grids[0], empty, report); });
  report.CopyTo(this->Report);
  if (vtkCompositeDataSet* composite = vtkCompositeDataSet::GetData(info))
  {
    SetRequestedTime(request, composite);
  }
  if (this->WarnOnEmptyOutput && empty.IsUnexplained(this))
  {
    vtkWarningMacro("The output is empty: " << this->ExplainEmpty(report.Time));
  }
  return 1;
}

void vtkSimplexTimeSlice::Slice(vtkDataSet* dataset, vtkInformation* request,
  vtkUnstructuredGrid* output, interlume::EmptyOutputDiagnosis& empty,
  interlume::SimplexTimeSliceReport& report)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::SafeDownCast(dataset);
  if (dataset->GetNumberOfPoints() == 0)
  {
    return;
  }
  report.Simplices += dataset->GetNumberOfCells();
  const double position = report.Time;
  const std::array<double, 4> normal = this->MakeNormal();
  if (const interlume::Error error = input ? CheckTimes(input, position, normal, this->IsAtTime())
                                           : std::string("A dataset of the input is a ") +
        dataset->GetClassName() + "; 4-simplices are the cells of a vtkUnstructuredGrid.")
  {
    vtkErrorMacro(<< error);
    empty.SetExplained();
    return;
  }
  const interlume::ExtractionValues values = interlume::ExtractionValues::ForContours({ position });
  vtkSmartPointer<vtkDataArray> positions = input->GetPointData()->GetArray(TimeName);
  if (this->IsAtTime())
  {
    positions = interlume::ExtractionDispatch::MakeContiguous(positions);
  }
  else
  {
    positions = MakePositions(input, positions, normal);
    double range[2];
    positions->GetFiniteRange(range, 0);
    this->InputRange[0] = std::min(this->InputRange[0], range[0]);
    this->InputRange[1] = std::max(this->InputRange[1], range[1]);
  }
  interlume::ExtractionContext context;
  context.Owner = this;
  context.Values = &values;
  context.Input = input;
  context.Scalars = positions;
  const interlume::NonFinitePoints nonFinite(input);
  context.NonFinitePoints = nonFinite.GetMarks();
  vtkNew<vtkCellData> cellData;
  cellData->ShallowCopy(input->GetCellData());
  // AtStep describes 4-simplices, not tetrahedra.
  cellData->RemoveArray("AtStep");
  context.KeepCellIds = cellData->GetNumberOfArrays() > 0;
  context.CellGhosts = input->GetCellGhostArray();
  context.PointGhosts = input->GetPointGhostArray();
  const int replaced = FindReplacedAxis(normal);
  interlume::SimplexSlicer::Slice slice;
  // Exchanging time and another coordinate reverses the orientation, and so does a normal that
  // points backward.
  const bool isMirrored = (replaced != TIME_AXIS) != (normal[replaced] < 0.0);
  if (!interlume::SimplexSlicer::Execute(context, input, { this->IsAtTime(), isMirrored }, slice))
  {
    return;
  }
  if (slice.InvalidCell >= 0)
  {
    vtkErrorMacro(
      "Cell " << slice.InvalidCell
              << " is not a 4-simplex (a VTK_POLY_VERTEX with five points): it has type "
              << input->GetCellType(slice.InvalidCell) << " and "
              << input->GetCells()->GetCellSize(slice.InvalidCell)
              << " points. Connect the output Simplices (port 2) of Time-Varying Interval Volume, "
                 "and turn its GenerateSimplices on.");
    empty.SetExplained();
    return;
  }
  interlume::PointArrays arrays(input, vtkAlgorithm::DEFAULT_PRECISION);
  arrays.Fill(slice.Points);
  output->SetPoints(arrays.GetPoints());
  output->SetCells(VTK_TETRA, slice.Tetrahedra.MakeCells());
  this->UpdateProgress(0.85);
  arrays.AddTo(output->GetPointData());
  if (this->IsAtTime())
  {
    FillTime(output->GetPointData(), output->GetNumberOfPoints(), position);
  }
  else if (replaced != TIME_AXIS)
  {
    output->GetPoints()->GetData()->CopyComponent(
      replaced, output->GetPointData()->GetArray(TimeName), 0);
  }
  this->UpdateProgress(0.95);
  interlume::ExtractionArrays::CopyCellData(cellData, slice.CellIds.GetData(),
    static_cast<vtkIdType>(slice.CellIds.GetSize()), output->GetCellData());
  empty.Add(input, nullptr, output->GetNumberOfCells());
  report.Tetrahedra += output->GetNumberOfCells();
  report.NonFiniteSimplices += slice.NonFiniteCells;
  const std::string skipped = nonFinite.Describe(input, 4);
  if (!skipped.empty())
  {
    vtkWarningMacro(<< skipped);
  }
  SetRequestedTime(request, output);
}

std::string vtkSimplexTimeSlice::ExplainEmpty(double position) const
{
  std::ostringstream why;
  if (this->InputRange[0] > this->InputRange[1])
  {
    why << "the input has no 4-simplices with times. Turn on GenerateSimplices of Time-Varying "
           "Interval Volume, and connect its output Simplices (port 2).";
  }
  else
  {
    why << "no 4-simplex has an extent in the slice at the "
        << (this->IsAtTime() ? "time " : "position ") << position << "; their "
        << (this->IsAtTime() ? "times" : "positions") << " range from " << this->InputRange[0]
        << " to " << this->InputRange[1] << ".";
  }
  return why.str();
}

void vtkSimplexTimeSlice::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SliceAxis: " << this->SliceAxis << "\n";
  os << indent << "Position: " << this->Position << "\n";
  os << indent << "Normal: (" << this->Normal[0] << ", " << this->Normal[1] << ", "
     << this->Normal[2] << ", " << this->Normal[3] << ")\n";
  os << indent << "Time: " << this->Time << "\n";
  os << indent << "FollowTime: " << this->FollowTime << "\n";
  os << indent << "WarnOnEmptyOutput: " << this->WarnOnEmptyOutput << "\n";
  os << indent << "Report:\n";
  this->Report->PrintSelf(os, indent.GetNextIndent());
}

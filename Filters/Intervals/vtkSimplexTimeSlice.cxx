// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSimplexTimeSlice.h"

#include "Arrays/ExtractionArrays.h"
#include "Pass/NonFinitePoints.h"
#include "Scalars/ExtractionDispatch.h"
#include "Scalars/ExtractionScalars.h"
#include "Static/EmptyResult.h"
#include "Static/ExtractionInput.h"
#include "TimeVarying/SimplexSlicer.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCommand.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
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

namespace
{
constexpr const char* TimeName = "Time";

// Sets the exact time: interpolated times would be off by a rounding, and float could not hold it.
void FillTime(vtkPointData* points, vtkIdType number, double time)
{
  vtkNew<vtkDoubleArray> times;
  times->SetName(TimeName);
  times->SetNumberOfValues(number);
  vtkSMPTools::Fill(times->GetPointer(0), times->GetPointer(0) + number, time);
  // The array goes in the place of the one of that name, whatever role it has.
  points->AddArray(times);
}

void AddTimes(vtkDataObject* leaf, double range[2])
{
  vtkDataSet* input = vtkDataSet::SafeDownCast(leaf);
  vtkDataArray* times = input ? input->GetPointData()->GetArray(TimeName) : nullptr;
  if (times && times->GetNumberOfComponents() == 1 && times->GetNumberOfTuples() > 0)
  {
    double own[2];
    times->GetFiniteRange(own, 0);
    range[0] = std::min(range[0], own[0]);
    range[1] = std::max(range[1], own[1]);
  }
}

// Finds the first and the last time of all datasets of an input; the first is above the last where
// there is none.
void FindTimes(vtkDataObject* input, double range[2])
{
  range[0] = std::numeric_limits<double>::infinity();
  range[1] = -std::numeric_limits<double>::infinity();
  vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    AddTimes(input, range);
    return;
  }
  const auto at = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
  {
    AddTimes(at->GetCurrentDataObject(), range);
  }
}
}

vtkSimplexTimeSlice::vtkSimplexTimeSlice()
  : InputRange{ 0.0, -1.0 }
  , Empty(std::make_unique<interlume::EmptyResult>())
{
  this->AddObserver(vtkCommand::StartEvent, this, &vtkSimplexTimeSlice::BeginExecution);
  this->AddObserver(vtkCommand::EndEvent, this, &vtkSimplexTimeSlice::WarnIfEmpty);
}

vtkSimplexTimeSlice::~vtkSimplexTimeSlice() = default;

int vtkSimplexTimeSlice::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

int vtkSimplexTimeSlice::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* output = outputs->GetInformationObject(0);
  output->Remove(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
  output->Remove(vtkStreamingDemandDrivenPipeline::TIME_RANGE());
  if (this->FollowTime)
  {
    // Without a range the pipeline would not execute for another time.
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

void vtkSimplexTimeSlice::BeginExecution()
{
  if (this->Empty->Enter())
  {
    FindTimes(this->GetInputDataObject(0, 0), this->InputRange);
    this->Report = vtkSimplexTimeSliceReport();
  }
}

double vtkSimplexTimeSlice::GetTimeOfSlice(vtkInformation* output) const
{
  vtkInformationDoubleKey* asked = vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP();
  if (!this->FollowTime || !output->Has(asked) || this->InputRange[0] > this->InputRange[1])
  {
    return this->Time;
  }
  return std::max(this->InputRange[0], std::min(output->Get(asked), this->InputRange[1]));
}

int vtkSimplexTimeSlice::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputs[0]);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputs);
  if (!input || input->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  this->SetProgressText("Cutting the 4-simplices");
  vtkInformation* outputInformation = outputs->GetInformationObject(0);
  const double time = this->GetTimeOfSlice(outputInformation);
  this->Report.Time = time;
  this->Report.Simplices += input->GetNumberOfCells();
  vtkAbstractArray* array = input->GetPointData()->GetAbstractArray(TimeName);
  const std::string wrong = interlume::ExtractionInput::CheckScalars(
    input, array, vtkDataObject::FIELD_ASSOCIATION_POINTS, "point array \"Time\"");
  if (!wrong.empty())
  {
    vtkErrorMacro(<< wrong);
    this->Empty->NoteMessage();
    return 1;
  }
  if (!std::isfinite(time))
  {
    vtkErrorMacro("The time of the slice is " << time << "; it has to be finite.");
    this->Empty->NoteMessage();
    return 1;
  }
  const interlume::ExtractionValues values = interlume::ExtractionValues::ForContours({ time });
  const vtkSmartPointer<vtkDataArray> times =
    interlume::ExtractionDispatch::MakeContiguous(vtkDataArray::SafeDownCast(array));
  interlume::ExtractionContext context;
  context.Owner = this;
  context.Values = &values;
  context.Input = input;
  context.Scalars = times;
  const interlume::NonFinitePoints nonFinite(input);
  context.NonFinitePoints = nonFinite.GetMarks();
  vtkNew<vtkCellData> cellData;
  cellData->ShallowCopy(input->GetCellData());
  // It tells of 4-simplices, not of tetrahedra.
  cellData->RemoveArray("AtStep");
  context.KeepCellIds = cellData->GetNumberOfArrays() > 0;
  context.CellGhosts = input->GetCellGhostArray();
  context.PointGhosts = input->GetPointGhostArray();
  interlume::SimplexSlicer::Slice slice;
  if (!interlume::SimplexSlicer::Execute(context, input, slice))
  {
    return 1;
  }
  if (slice.WrongCell >= 0)
  {
    vtkErrorMacro(
      "Cell " << slice.WrongCell
              << " is no 4-simplex, which is a VTK_POLY_VERTEX of five points: it has type "
              << input->GetCellType(slice.WrongCell) << " and "
              << input->GetCells()->GetCellSize(slice.WrongCell) << " points.");
    this->Empty->NoteMessage();
    return 1;
  }
  output->SetPoints(
    interlume::ExtractionArrays::MakePoints(input, slice.Points, vtkAlgorithm::DEFAULT_PRECISION));
  output->SetCells(VTK_TETRA, slice.Tetrahedra.MakeCells());
  this->UpdateProgress(0.85);
  interlume::ExtractionArrays::InterpolatePointData(
    input->GetPointData(), slice.Points, output->GetPointData());
  FillTime(output->GetPointData(), output->GetNumberOfPoints(), time);
  this->UpdateProgress(0.95);
  interlume::ExtractionArrays::CopyCellData(cellData, slice.CellIds.GetData(),
    static_cast<vtkIdType>(slice.CellIds.GetSize()), output->GetCellData());
  this->Empty->Add(input, nullptr, output->GetNumberOfCells());
  this->Report.Tetrahedra += output->GetNumberOfCells();
  this->Report.NonFiniteSimplices += slice.NonFiniteCells;
  const std::string skipped = nonFinite.Describe(input, true);
  if (!skipped.empty())
  {
    vtkWarningMacro(<< skipped);
  }
  if (this->FollowTime &&
    outputInformation->Has(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()))
  {
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(),
      outputInformation->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()));
  }
  return 1;
}

void vtkSimplexTimeSlice::WarnIfEmpty()
{
  if (!this->Empty->Leave())
  {
    return;
  }
  std::ostringstream why;
  if (this->InputRange[0] > this->InputRange[1])
  {
    why << "the input has no 4-simplices with times. (A time-varying interval volume makes them "
           "where "
           "GenerateSimplices is on.)";
  }
  else
  {
    why << "no 4-simplex has an extent in space at the time " << this->Report.Time
        << "; their times go from " << this->InputRange[0] << " to " << this->InputRange[1] << ".";
  }
  if (this->WarnOnEmptyOutput && this->Empty->IsUnexplained(this))
  {
    vtkWarningMacro("The output is empty: " << why.str());
  }
}

void vtkSimplexTimeSlice::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Time: " << this->Time << "\n";
  os << indent << "FollowTime: " << this->FollowTime << "\n";
  os << indent << "WarnOnEmptyOutput: " << this->WarnOnEmptyOutput << "\n";
  os << indent << "Report:\n";
  this->Report.Print(os, indent.GetNextIndent());
}

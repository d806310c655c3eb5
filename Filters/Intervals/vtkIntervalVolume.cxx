// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIntervalVolume.h"

#include "Arrays/ExtractionArrays.h"
#include "Common/IntervalCheck.h"
#include "Grid/WholeCells.h"
#include "Output/KeptMemory.h"
#include "Output/ProcessBalance.h"
#include "Pass/ExtractionIndex.h"
#include "Pass/GhostCells.h"
#include "Static/EmptyResult.h"
#include "Static/Extraction.h"
#include "Static/ExtractionInput.h"
#include "Static/RefinementLevels.h"

#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <limits>
#include <sstream>

vtkStandardNewMacro(vtkIntervalVolume);

namespace
{
// Reads a whole text as a number; NaN where it is none.
double ReadNumber(const std::string& text)
{
  std::istringstream stream(text);
  double number;
  std::string rest;
  return stream >> number && !(stream >> rest) ? number : std::numeric_limits<double>::quiet_NaN();
}
}

vtkIntervalVolume::vtkIntervalVolume()
  : Index(vtkSmartPointer<interlume::ExtractionIndex>::New())
  , Empty(std::make_unique<interlume::EmptyResult>())
{
  this->AddObserver(vtkCommand::StartEvent, this, &vtkIntervalVolume::BeginExecution);
  this->AddObserver(vtkCommand::EndEvent, this, &vtkIntervalVolume::EndExecution);
  this->SetNumberOfOutputPorts(2);
}

vtkIntervalVolume::~vtkIntervalVolume() = default;

void vtkIntervalVolume::AddCriterion(const char* arrayName, double lower, double upper)
{
  this->Criteria.push_back({ arrayName ? arrayName : "", lower, upper, std::string() });
  this->Modified();
}

void vtkIntervalVolume::AddCriterionAsText(
  const char* arrayName, const char* lower, const char* upper)
{
  std::string wrong;
  for (const char* text : { lower, upper })
  {
    if (wrong.empty() && (!text || std::isnan(ReadNumber(text))))
    {
      wrong = text && *text ? std::string("\"") + text + "\"" : "nothing";
    }
  }
  this->AddCriterion(
    arrayName, lower ? ReadNumber(lower) : std::nan(""), upper ? ReadNumber(upper) : std::nan(""));
  this->Criteria.back().WrongText = wrong;
}

void vtkIntervalVolume::RemoveAllCriteria()
{
  if (!this->Criteria.empty())
  {
    this->Criteria.clear();
    this->Modified();
  }
}

const char* vtkIntervalVolume::GetCriterionArrayName(int i) const
{
  return i >= 0 && i < this->GetNumberOfCriteria() ? this->Criteria[i].ArrayName.c_str() : nullptr;
}

void vtkIntervalVolume::GetCriterionRange(int i, double& lower, double& upper) const
{
  if (i >= 0 && i < this->GetNumberOfCriteria())
  {
    lower = this->Criteria[i].Lower;
    upper = this->Criteria[i].Upper;
  }
}

int vtkIntervalVolume::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

int vtkIntervalVolume::ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputs,
  vtkInformationVector* outputs, int port, vtkMTimeType* time)
{
  // The pipeline asks once before it executes, but runs the filter for each leaf of a composite
  // input.
  this->IsFirstRun = true;
  return this->Superclass::ComputePipelineMTime(request, inputs, outputs, port, time);
}

std::string vtkIntervalVolume::CheckParameters(vtkDataSet* input) const
{
  std::string wrongInterval = interlume::ExtractionInput::CheckIntervals(this->GetIntervals());
  if (!wrongInterval.empty())
  {
    return wrongInterval;
  }
  for (const Criterion& criterion : this->Criteria)
  {
    std::string wrong = interlume::ExtractionInput::CheckScalars(input,
      input->GetPointData()->GetAbstractArray(criterion.ArrayName.c_str()),
      vtkDataObject::FIELD_ASSOCIATION_POINTS,
      "point array \"" + criterion.ArrayName + "\" of a criterion");
    if (wrong.empty() && !criterion.WrongText.empty())
    {
      wrong = "The criterion on \"" + criterion.ArrayName + "\" has " + criterion.WrongText +
        " for a bound, which is no number.";
    }
    if (wrong.empty())
    {
      wrong = interlume::IntervalCheck::Find(
        "The criterion on \"" + criterion.ArrayName + "\"", criterion.Lower, criterion.Upper);
    }
    if (!wrong.empty())
    {
      return wrong;
    }
  }
  return std::string();
}

int vtkIntervalVolume::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  interlume::GhostCells::Request(
    inputs[0]->GetInformationObject(0), outputs->GetInformationObject(0));
  return 1;
}

int vtkIntervalVolume::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (this->IsFirstRun)
  {
    this->Report = vtkExtractionReport();
    this->Index->BeginExecution();
    this->BeginMemory();
    this->IsFirstRun = false;
  }
  vtkDataSet* input = vtkDataSet::GetData(inputs[0]);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputs, 0);
  vtkUnstructuredGrid* boundary = vtkUnstructuredGrid::GetData(outputs, 1);
  if (!input || input->GetNumberOfPoints() == 0 || this->GetNumberOfIntervals() == 0)
  {
    return 1;
  }
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkAbstractArray* array = this->GetInputAbstractArrayToProcess(0, inputs, association);
  std::string wrong = interlume::ExtractionInput::CheckScalars(
    input, array, association, interlume::ExtractionInput::DescribeArrayToProcess(this));
  wrong = wrong.empty() ? this->CheckParameters(input) : wrong;
  if (!wrong.empty())
  {
    vtkErrorMacro(<< wrong);
    this->Empty->NoteMessage();
    return 1;
  }
  const interlume::KeptMemory::Use use(this->Memory.get());
  const int passes = 1 + this->GetNumberOfCriteria();
  this->SetProgressShiftScale(0.0, 1.0 / passes);
  vtkDataArray* scalars = vtkDataArray::SafeDownCast(array);
  this->SetProgressText("Extracting the intervals");
  interlume::WholePass wholePass;
  interlume::WholePass* const whole = this->KeepWholeCells ? &wholePass : nullptr;
  bool completed = this->ExtractIntervals(input, scalars, whole, output, boundary);
  this->Empty->Add(input, scalars, output->GetNumberOfCells());
  for (int pass = 1; completed && pass < passes; ++pass)
  {
    this->SetProgressText(
      ("Cutting to the criterion on " + this->Criteria[pass - 1].ArrayName).c_str());
    this->SetProgressShiftScale(static_cast<double>(pass) / passes, 1.0 / passes);
    completed = this->ApplyCriterion(pass - 1, whole, output, boundary);
  }
  this->SetProgressShiftScale(0.0, 1.0);
  for (vtkUnstructuredGrid* grid : { output, boundary })
  {
    if (completed)
    {
      interlume::ExtractionArrays::ActivateScalars(scalars->GetName(), grid->GetPointData());
    }
    else
    {
      grid->Initialize();
    }
    // The pipeline has passed field data on to the outputs, which criteria and an abort empty.
    grid->GetFieldData()->ShallowCopy(input->GetFieldData());
  }
  this->Report.Passes = completed ? passes : this->Report.Passes;
  return 1;
}

void vtkIntervalVolume::BeginMemory()
{
  if (!this->KeepMemory)
  {
    this->Memory.reset();
    return;
  }
  if (!this->Memory)
  {
    this->Memory = std::make_unique<interlume::KeptMemory>();
  }
  this->Memory->BeginExecution();
}

void vtkIntervalVolume::EndMemory()
{
  if (this->Memory)
  {
    this->Memory->EndExecution();
    this->Report.ReusedBytes = static_cast<vtkIdType>(this->Memory->GetBytesReused());
    this->Report.IdleBytes = static_cast<vtkIdType>(this->Memory->GetBytesIdle());
  }
}

bool vtkIntervalVolume::ExtractIntervals(vtkDataSet* input, vtkDataArray* scalars,
  interlume::WholePass* whole, vtkUnstructuredGrid* output, vtkUnstructuredGrid* boundary)
{
  for (const Criterion& criterion : this->Criteria)
  {
    if (whole)
    {
      whole->Exclude(input->GetPointData()->GetArray(criterion.ArrayName.c_str()), criterion.Lower,
        criterion.Upper);
    }
  }
  const interlume::ExtractionValues values =
    interlume::ExtractionValues::ForIntervals(this->GetIntervals());
  vtkExtractionReport report;
  interlume::Extraction extraction;
  extraction.Owner = this;
  extraction.Values = &values;
  extraction.Index = this->UseValueIndex ? this->Index.GetPointer() : nullptr;
  extraction.IdName = "IntervalId";
  extraction.OutputPointsPrecision = this->GetOutputPointsPrecision();
  extraction.GenerateBoundaries = this->GenerateBoundaries;
  extraction.KeepOrigins = this->KeepOrigins && this->Criteria.empty();
  extraction.Whole = whole;
  const bool completed = extraction.Execute(input, scalars, output, boundary, report);
  this->Report.Add(report);
  for (const std::string& warning :
    interlume::ExtractionInput::GetWarnings(input, this->GetOutputPointsPrecision(), report))
  {
    vtkWarningMacro(<< warning);
  }
  return completed;
}

bool vtkIntervalVolume::ApplyCriterion(
  int number, interlume::WholePass* whole, vtkUnstructuredGrid* grid, vtkUnstructuredGrid* boundary)
{
  const Criterion& criterion = this->Criteria[number];
  vtkNew<vtkUnstructuredGrid> before;
  vtkNew<vtkUnstructuredGrid> boundaryBefore;
  before->ShallowCopy(grid);
  boundaryBefore->ShallowCopy(boundary);
  grid->Initialize();
  boundary->Initialize();
  const interlume::ExtractionValues values =
    interlume::ExtractionValues::ForIntervals({ { { criterion.Lower, criterion.Upper } } });
  vtkExtractionReport report;
  interlume::Extraction extraction;
  extraction.Owner = this;
  extraction.Values = &values;
  extraction.KeepOrientation = true;
  extraction.Whole = whole;
  extraction.InputBoundary = this->GenerateBoundaries ? boundaryBefore.GetPointer() : nullptr;
  vtkDataArray* array = before->GetPointData()->GetArray(criterion.ArrayName.c_str());
  const bool completed = extraction.Execute(before, array, grid, boundary, report);
  std::ostringstream words;
  words << "the criterion on \"" << criterion.ArrayName << "\" from " << criterion.Lower << " to "
        << criterion.Upper;
  this->Empty->AddCriterion(
    number, words.str(), array, before->GetNumberOfCells(), grid->GetNumberOfCells());
  this->Report.CollapsedSimplices += report.CollapsedSimplices;
  this->Report.WorkingBytes = std::max(this->Report.WorkingBytes,
    report.WorkingBytes + 1024 * static_cast<vtkIdType>(before->GetActualMemorySize()));
  return completed;
}

void vtkIntervalVolume::BeginExecution()
{
  this->Empty->Enter();
}

void vtkIntervalVolume::EndExecution()
{
  if (!this->Empty->Leave())
  {
    return;
  }
  if (this->IsFirstRun)
  {
    // There was no dataset at all.
    this->Report = vtkExtractionReport();
    this->BeginMemory();
  }
  this->EndMemory();
  int association;
  interlume::RefinementLevels::Count(
    this->GetInputDataObject(0, 0), this->GetIntervals(),
    [this, &association](vtkDataSet* block)
    { return this->GetInputAbstractArrayToProcess(0, block, association); },
    this->Report);
  for (const std::string& warning : interlume::RefinementLevels::GetWarnings(this->Report))
  {
    vtkWarningMacro(<< warning);
  }
  if (this->GetReportBalance())
  {
    interlume::ProcessBalance::Gather(this, this->Report);
  }
  this->WarnOfEmptyOutput(
    this->Empty->Explain(this, this->GetNumberOfIntervals() == 0 ? "no interval is set." : "",
      interlume::EmptyResult::Describe(this->GetIntervals())));
}

void vtkIntervalVolume::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Criteria: " << this->Criteria.size() << "\n";
  for (const Criterion& criterion : this->Criteria)
  {
    os << indent.GetNextIndent() << criterion.ArrayName << ": " << criterion.Lower << " to "
       << criterion.Upper << "\n";
  }
  os << indent << "GenerateBoundaries: " << this->GenerateBoundaries << "\n";
  os << indent << "KeepWholeCells: " << this->KeepWholeCells << "\n";
  os << indent << "KeepOrigins: " << this->KeepOrigins << "\n";
  os << indent << "UseValueIndex: " << this->UseValueIndex << "\n";
  os << indent << "KeepMemory: " << this->KeepMemory << "\n";
  os << indent << "Report:\n";
  this->Report.Print(os, indent.GetNextIndent());
}

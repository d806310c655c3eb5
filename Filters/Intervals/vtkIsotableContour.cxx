// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIsotableContour.h"

#include "Arrays/ExtractionArrays.h"
#include "Common/IntervalCheck.h"
#include "Output/ProcessBalance.h"
#include "Pass/ExtractionIndex.h"
#include "Pass/GhostCells.h"
#include "Static/EmptyResult.h"
#include "Static/Extraction.h"
#include "Static/ExtractionInput.h"
#include "Static/RefinementLevels.h"

#include "vtkCommand.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkIsotableContour);

namespace
{
constexpr int MaximumNumberOfContours = 20000;
}

vtkIsotableContour::vtkIsotableContour()
  : Index(vtkSmartPointer<interlume::ExtractionIndex>::New())
  , Empty(std::make_unique<interlume::EmptyResult>())
{
  this->AddObserver(vtkCommand::StartEvent, this, &vtkIsotableContour::BeginExecution);
  this->AddObserver(vtkCommand::EndEvent, this, &vtkIsotableContour::EndExecution);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

vtkIsotableContour::~vtkIsotableContour() = default;

void vtkIsotableContour::SetNumberOfContours(int number)
{
  number = std::max(0, std::min(number, MaximumNumberOfContours));
  if (number != this->GetNumberOfContours())
  {
    this->Values.resize(number, 0.0);
    this->Modified();
  }
}

void vtkIsotableContour::SetValue(int i, double value)
{
  if (i < 0 || i >= MaximumNumberOfContours)
  {
    vtkErrorMacro(
      "Contour index " << i << " is not in 0 to " << MaximumNumberOfContours - 1 << ".");
    return;
  }
  if (i >= this->GetNumberOfContours())
  {
    this->SetNumberOfContours(i + 1);
  }
  if (this->Values[i] != value)
  {
    this->Values[i] = value;
    this->Modified();
  }
}

double vtkIsotableContour::GetValue(int i) const
{
  return i >= 0 && i < this->GetNumberOfContours() ? this->Values[i] : 0.0;
}

int vtkIsotableContour::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

int vtkIsotableContour::ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputs,
  vtkInformationVector* outputs, int port, vtkMTimeType* time)
{
  // The pipeline asks once before it executes, but runs the filter for each leaf of a composite
  // input.
  this->IsFirstRun = true;
  return this->Superclass::ComputePipelineMTime(request, inputs, outputs, port, time);
}

int vtkIsotableContour::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  interlume::GhostCells::Request(
    inputs[0]->GetInformationObject(0), outputs->GetInformationObject(0));
  return 1;
}

int vtkIsotableContour::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (this->IsFirstRun)
  {
    this->Report = vtkExtractionReport();
    this->Index->BeginExecution();
    this->IsFirstRun = false;
  }
  vtkDataSet* input = vtkDataSet::GetData(inputs[0]);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputs);
  if (!input || input->GetNumberOfPoints() == 0 || this->Values.empty())
  {
    return 1;
  }
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkAbstractArray* array = this->GetInputAbstractArrayToProcess(0, inputs, association);
  std::string wrong = interlume::ExtractionInput::CheckScalars(
    input, array, association, interlume::ExtractionInput::DescribeArrayToProcess(this));
  for (std::size_t i = 0; wrong.empty() && i < this->Values.size(); ++i)
  {
    wrong = interlume::IntervalCheck::Find(
      "Value " + std::to_string(i), this->Values[i], this->Values[i]);
  }
  if (!wrong.empty())
  {
    vtkErrorMacro(<< wrong);
    this->Empty->NoteMessage();
    return 1;
  }
  const interlume::ExtractionValues values = interlume::ExtractionValues::ForContours(this->Values);
  vtkExtractionReport report;
  interlume::Extraction extraction;
  extraction.Owner = this;
  extraction.Values = &values;
  extraction.Index = this->UseValueIndex ? this->Index.GetPointer() : nullptr;
  extraction.IdName = "ContourId";
  extraction.OutputPointsPrecision = this->OutputPointsPrecision;
  extraction.SharePoints = this->MergePoints;
  vtkDataArray* scalars = vtkDataArray::SafeDownCast(array);
  this->SetProgressText("Extracting the isosurfaces");
  if (!extraction.Execute(input, scalars, output, nullptr, report))
  {
    output->Initialize();
  }
  interlume::ExtractionArrays::ActivateScalars(scalars->GetName(), output->GetPointData());
  this->Empty->Add(input, scalars, output->GetNumberOfCells());
  report.Passes = 1;
  this->Report.Add(report);
  for (const std::string& warning :
    interlume::ExtractionInput::GetWarnings(input, this->OutputPointsPrecision, report))
  {
    vtkWarningMacro(<< warning);
  }
  return 1;
}

void vtkIsotableContour::BeginExecution()
{
  this->Empty->Enter();
}

void vtkIsotableContour::EndExecution()
{
  if (!this->Empty->Leave())
  {
    return;
  }
  if (this->IsFirstRun)
  {
    // There was no dataset at all.
    this->Report = vtkExtractionReport();
  }
  std::vector<vtkIntervalList::Interval> surfaces;
  for (const double value : this->Values)
  {
    surfaces.push_back({ { value, value } });
  }
  int association;
  interlume::RefinementLevels::Count(
    this->GetInputDataObject(0, 0), surfaces,
    [this, &association](vtkDataSet* block)
    { return this->GetInputAbstractArrayToProcess(0, block, association); },
    this->Report);
  for (const std::string& warning : interlume::RefinementLevels::GetWarnings(this->Report))
  {
    vtkWarningMacro(<< warning);
  }
  if (this->ReportBalance)
  {
    interlume::ProcessBalance::Gather(this, this->Report);
  }
  const std::string why = this->Empty->Explain(this, this->Values.empty() ? "no value is set." : "",
    interlume::EmptyResult::Describe(this->Values));
  if (this->WarnOnEmptyOutput && !why.empty())
  {
    vtkWarningMacro("The output is empty: " << why);
  }
}

void vtkIsotableContour::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfContours: " << this->Values.size() << "\n";
  os << indent << "Values:\n";
  for (double value : this->Values)
  {
    os << indent.GetNextIndent() << value << "\n";
  }
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
  os << indent << "MergePoints: " << this->MergePoints << "\n";
  os << indent << "UseValueIndex: " << this->UseValueIndex << "\n";
  os << indent << "WarnOnEmptyOutput: " << this->WarnOnEmptyOutput << "\n";
  os << indent << "ReportBalance: " << this->ReportBalance << "\n";
  os << indent << "Report:\n";
  this->Report.Print(os, indent.GetNextIndent());
}

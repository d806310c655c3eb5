// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIsotableContour.h"

#include "Arrays/ExtractionArrays.h"
#include "Common/IntervalCheck.h"
#include "Pass/ExtractionIndex.h"
#include "Pass/GhostCells.h"
#include "Static/DataSetLeaves.h"
#include "Static/Extraction.h"
#include "Static/ExtractionRun.h"

#include "vtkDataSet.h"
#include "vtkDemandDrivenPipeline.h"
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
{
  interlume::ExtractionReport().CopyTo(this->Report);
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
      "Contour index " << i << " is not in the range 0 to " << MaximumNumberOfContours - 1 << ".");
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
  interlume::DataSetLeaves::FillInput(info, "vtkDataSet");
  return 1;
}

int vtkIsotableContour::FillOutputPortInformation(int, vtkInformation* info)
{
  interlume::DataSetLeaves::FillOutput(info);
  return 1;
}

vtkTypeBool vtkIsotableContour::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT())
    ? interlume::DataSetLeaves::RequestDataObject(inputs, outputs)
    : this->Superclass::ProcessRequest(request, inputs, outputs);
}

int vtkIsotableContour::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  interlume::GhostCells::Request(
    inputs[0]->GetInformationObject(0), outputs->GetInformationObject(0));
  interlume::CellArrayConversion::RequestGhostCells(this, inputs, outputs);
  return 1;
}

int vtkIsotableContour::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  interlume::ExtractionIndex* const index =
    this->Index->BeginExecution(this->UseValueIndex, this->PreviewCellLimit > 0);
  interlume::ExtractionRun run(this, {}, index, this->PreviewCellLimit);
  interlume::DataSetLeaves::ForEach(this, inputs, outputs,
    [&](vtkDataSet* input, const std::vector<vtkUnstructuredGrid*>& grids)
    { this->ExtractFrom(input, run, grids[0]); });
  std::vector<vtkIntervalList::Interval> surfaces;
  for (const double value : this->Values)
  {
    surfaces.push_back({ { value, value } });
  }
  run.Finish({ surfaces, interlume::EmptyOutputDiagnosis::Describe(this->Values),
               this->Values.empty() ? "no value is set." : "" },
    this->ReportBalance, this->WarnOnEmptyOutput, this->Report);
  return 1;
}

interlume::Error vtkIsotableContour::CheckValues() const
{
  interlume::Error error;
  for (std::size_t i = 0; !error && i < this->Values.size(); ++i)
  {
    error = interlume::IntervalCheck::FindError(
      "Value " + std::to_string(i), this->Values[i], this->Values[i]);
  }
  return error;
}

void vtkIsotableContour::ExtractFrom(
  vtkDataSet* input, interlume::ExtractionRun& run, vtkUnstructuredGrid* output)
{
  if (input->GetNumberOfPoints() == 0 || this->Values.empty())
  {
    return;
  }
  vtkDataArray* scalars = run.FindScalars(input, [this] { return this->CheckValues(); });
  if (!scalars)
  {
    return;
  }
  const interlume::ExtractionValues values = interlume::ExtractionValues::ForContours(this->Values);
  interlume::ExtractionReport report;
  interlume::Extraction extraction;
  extraction.Owner = this;
  extraction.Values = &values;
  extraction.Index = run.GetIndex();
  extraction.IdName = "ContourId";
  extraction.OutputPointsPrecision = this->OutputPointsPrecision;
  extraction.SharePoints = this->MergePoints;
  this->SetProgressText("Extracting the isosurfaces");
  if (!extraction.Execute(input, scalars, output, nullptr, report))
  {
    output->Initialize();
  }
  interlume::ExtractionArrays::ActivateScalars(scalars->GetName(), output->GetPointData());
  run.GetEmptyOutputDiagnosis().Add(input, scalars, output->GetNumberOfCells());
  report.Passes = 1;
  run.Add(input, 3, this->OutputPointsPrecision, report);
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
  os << indent << "PreviewCellLimit: " << this->PreviewCellLimit << "\n";
  os << indent << "WarnOnEmptyOutput: " << this->WarnOnEmptyOutput << "\n";
  os << indent << "ReportBalance: " << this->ReportBalance << "\n";
  os << indent << "Report:\n";
  this->Report->PrintSelf(os, indent.GetNextIndent());
}

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIntervalAlgorithm.h"

#include "Arrays/ExtractionArrays.h"
#include "Common/CellArrayConversion.h"
#include "Common/Error.h"
#include "Common/IntervalCheck.h"
#include "Pass/GhostCells.h"
#include "Static/DataSetLeaves.h"
#include "Static/EmptyOutputDiagnosis.h"
#include "Static/ExtractionInput.h"

#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"

#include <cmath>
#include <limits>
#include <sstream>

namespace
{
// Parses a number. Returns NaN if the text is not a number.
double ReadNumber(const std::string& text)
{
  std::istringstream stream(text);
  double number;
  std::string rest;
  return stream >> number && !(stream >> rest) ? number : std::numeric_limits<double>::quiet_NaN();
}
}

vtkIntervalAlgorithm::vtkIntervalAlgorithm()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

void vtkIntervalAlgorithm::SetNumberOfIntervals(int number)
{
  this->Intervals.SetNumber(number, this);
}

void vtkIntervalAlgorithm::SetInterval(int i, double lower, double upper)
{
  if (const interlume::Error error = this->Intervals.Set(i, lower, upper, this))
  {
    vtkErrorMacro(<< error);
  }
}

void vtkIntervalAlgorithm::GetInterval(int i, double& lower, double& upper) const
{
  this->Intervals.Get(i, lower, upper);
}

void vtkIntervalAlgorithm::AddCriterion(const char* arrayName, double lower, double upper)
{
  this->Criteria.push_back({ arrayName ? arrayName : "", lower, upper, std::string() });
  this->Modified();
}

void vtkIntervalAlgorithm::AddCriterionAsText(
  const char* arrayName, const char* lower, const char* upper)
{
  std::string invalid;
  for (const char* text : { lower, upper })
  {
    if (invalid.empty() && (!text || std::isnan(ReadNumber(text))))
    {
      invalid = text && *text ? std::string("\"") + text + "\"" : "(empty)";
    }
  }
  this->AddCriterion(
    arrayName, lower ? ReadNumber(lower) : std::nan(""), upper ? ReadNumber(upper) : std::nan(""));
  this->Criteria.back().InvalidBound = invalid;
}

void vtkIntervalAlgorithm::RemoveAllCriteria()
{
  if (!this->Criteria.empty())
  {
    this->Criteria.clear();
    this->Modified();
  }
}

const char* vtkIntervalAlgorithm::GetCriterionArrayName(int i) const
{
  return i >= 0 && i < this->GetNumberOfCriteria() ? this->Criteria[i].ArrayName.c_str() : nullptr;
}

void vtkIntervalAlgorithm::GetCriterionRange(int i, double& lower, double& upper) const
{
  if (i >= 0 && i < this->GetNumberOfCriteria())
  {
    lower = this->Criteria[i].Lower;
    upper = this->Criteria[i].Upper;
  }
}

std::vector<std::string> vtkIntervalAlgorithm::GetCriteriaArrayNames() const
{
  std::vector<std::string> names;
  for (const Criterion& criterion : this->Criteria)
  {
    names.push_back(criterion.ArrayName);
  }
  return names;
}

interlume::Error vtkIntervalAlgorithm::CheckCriteria(vtkDataSet* input) const
{
  interlume::Error error;
  for (std::size_t i = 0; !error && i < this->Criteria.size(); ++i)
  {
    const Criterion& criterion = this->Criteria[i];
    const std::string name = "The criterion on \"" + criterion.ArrayName + "\"";
    // Valid cell arrays have been converted to point arrays.
    const auto array = interlume::CellArrayConversion::FindByName(input, criterion.ArrayName);
    error = interlume::ExtractionInput::CheckScalars(input, array.Array, array.Association,
      "point or cell array \"" + criterion.ArrayName + "\" of a criterion");
    if (!error && !interlume::ExtractionArrays::IsCarried(input->GetPointData(), array.Array))
    {
      error = name +
        " needs an array of values, but these are ids or ghost flags. Copy them to an array with "
        "another name that is not an active attribute.";
    }
    if (!error && !criterion.InvalidBound.empty())
    {
      error = name + " has the bound " + criterion.InvalidBound +
        ", which is not a number. Enter a number.";
    }
    error = error.Then(
      [&] { return interlume::IntervalCheck::FindError(name, criterion.Lower, criterion.Upper); });
  }
  return error;
}

std::string vtkIntervalAlgorithm::DescribeIntervals() const
{
  return interlume::EmptyOutputDiagnosis::Describe(this->GetIntervals()) +
    (this->CriteriaOperation == UNION && !this->Criteria.empty() ? " or satisfies a criterion"
                                                                 : "");
}

std::string vtkIntervalAlgorithm::DescribeCriterion(int number) const
{
  const Criterion& criterion = this->Criteria[number];
  std::ostringstream description;
  description << "the criterion on \"" << criterion.ArrayName << "\" from " << criterion.Lower
              << " to " << criterion.Upper;
  return description.str();
}

int vtkIntervalAlgorithm::FillInputPortInformation(int, vtkInformation* info)
{
  interlume::DataSetLeaves::FillInput(info, "vtkDataSet");
  return 1;
}

int vtkIntervalAlgorithm::FillOutputPortInformation(int, vtkInformation* info)
{
  interlume::DataSetLeaves::FillOutput(info);
  return 1;
}

vtkTypeBool vtkIntervalAlgorithm::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT())
    ? interlume::DataSetLeaves::RequestDataObject(inputs, outputs)
    : this->Superclass::ProcessRequest(request, inputs, outputs);
}

int vtkIntervalAlgorithm::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  interlume::GhostCells::Request(
    inputs[0]->GetInformationObject(0), outputs->GetInformationObject(0));
  interlume::CellArrayConversion::RequestGhostCells(this, inputs, outputs);
  return 1;
}

void vtkIntervalAlgorithm::WarnOfEmptyOutput(const std::string& why)
{
  if (this->WarnOnEmptyOutput && this->PreviewCellLimit == 0 && !why.empty())
  {
    vtkWarningMacro("The output is empty: " << why);
  }
}

void vtkIntervalAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->Intervals.Print(os, indent);
  os << indent << "Criteria: " << this->Criteria.size() << "\n";
  for (const Criterion& criterion : this->Criteria)
  {
    os << indent.GetNextIndent() << criterion.ArrayName << ": " << criterion.Lower << " to "
       << criterion.Upper << "\n";
  }
  os << indent << "CriteriaOperation: " << this->CriteriaOperation << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
  os << indent << "WarnOnEmptyOutput: " << this->WarnOnEmptyOutput << "\n";
  os << indent << "SizeWarningLimit: " << this->SizeWarningLimit << "\n";
  os << indent << "PreviewCellLimit: " << this->PreviewCellLimit << "\n";
  os << indent << "ReportBalance: " << this->ReportBalance << "\n";
}

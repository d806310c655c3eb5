// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIntervalAlgorithm.h"

#include "Common/CellArrayConversion.h"
#include "Common/Error.h"
#include "Pass/GhostCells.h"
#include "Static/DataSetLeaves.h"

#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"

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
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
  os << indent << "WarnOnEmptyOutput: " << this->WarnOnEmptyOutput << "\n";
  os << indent << "SizeWarningLimit: " << this->SizeWarningLimit << "\n";
  os << indent << "PreviewCellLimit: " << this->PreviewCellLimit << "\n";
  os << indent << "ReportBalance: " << this->ReportBalance << "\n";
}

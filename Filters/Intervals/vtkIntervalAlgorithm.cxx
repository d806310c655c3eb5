// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIntervalAlgorithm.h"

#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"

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
  const std::string wrong = this->Intervals.Set(i, lower, upper, this);
  if (!wrong.empty())
  {
    vtkErrorMacro(<< wrong);
  }
}

void vtkIntervalAlgorithm::GetInterval(int i, double& lower, double& upper) const
{
  this->Intervals.Get(i, lower, upper);
}

void vtkIntervalAlgorithm::WarnOfEmptyOutput(const std::string& why)
{
  if (this->WarnOnEmptyOutput && !why.empty())
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
  os << indent << "ReportBalance: " << this->ReportBalance << "\n";
}

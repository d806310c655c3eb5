// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMProposedRangeDomain.h"

#include "vtkObjectFactory.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVTemporalDataInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkPropertyPush.h"
#include "vtkSMOutputPort.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMUncheckedPropertyHelper.h"
#include "vtkSMVectorProperty.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkSMProposedRangeDomain);

namespace
{
bool HasValues(vtkSMProperty* property, bool useUnchecked, const std::vector<double>& values)
{
  vtkSMPropertyHelper helper(property, /*quiet=*/true);
  helper.SetUseUnchecked(useUnchecked);
  return !values.empty() && helper.GetDoubleArray() == values;
}
}

vtkSMProposedRangeDomain::vtkSMProposedRangeDomain() = default;
vtkSMProposedRangeDomain::~vtkSMProposedRangeDomain() = default;

int vtkSMProposedRangeDomain::ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element)
{
  if (!this->Superclass::ReadXMLAttributes(property, element))
  {
    return 0;
  }
  element->GetScalarAttribute("all_time_steps", &this->AllTimeSteps);
  return 1;
}

unsigned int vtkSMProposedRangeDomain::GetRowSize()
{
  // The row size is not available in ReadXMLAttributes: the property sets it after creating its
  // domains.
  vtkSMVectorProperty* rows = vtkSMVectorProperty::SafeDownCast(this->GetProperty());
  return rows ? std::max(rows->GetNumberOfElementsPerCommand(), 1) : 1;
}

bool vtkSMProposedRangeDomain::FindRange(
  const vtkArraySelection& selection, bool overTime, double range[2])
{
  selection.Producer->CreateOutputPorts();
  vtkPVArrayInformation* found = nullptr;
  if (overTime)
  {
    vtkSMOutputPort* port = selection.Producer->GetOutputPort(selection.Port);
    vtkPVTemporalDataInformation* information = port ? port->GetTemporalDataInformation() : nullptr;
    found = information
      ? information->GetArrayInformation(selection.Name.c_str(), selection.Association)
      : nullptr;
  }
  else if (vtkPVDataInformation* information =
             selection.Producer->GetDataInformation(selection.Port))
  {
    found = information->GetArrayInformation(selection.Name.c_str(), selection.Association);
  }
  if (!found || found->GetNumberOfComponents() != 1)
  {
    return false;
  }
  found->GetComponentFiniteRange(0, range);
  return range[0] <= range[1];
}

bool vtkSMProposedRangeDomain::CanReadAllTimeSteps(const vtkArraySelection& selection)
{
  const int steps = selection.GetNumberOfTimeSteps();
  if (steps < 2)
  {
    return false;
  }
  const double size = selection.GetSeriesSize();
  if (size > vtkArraySelection::MaximumSeriesSize)
  {
    if (this->WarnedSelection == selection)
    {
      return false;
    }
    this->WarnedSelection = selection;
    vtkWarningMacro(
      "The default values use the range of the current time step only, because reading all "
      << steps << " time steps requires about " << std::round(size / 1e6)
      << " GB. Check the values against the other time steps.");
    return false;
  }
  return true;
}

void vtkSMProposedRangeDomain::SetRange(const double range[2])
{
  this->SetEntries(std::vector<vtkEntry>(this->GetRowSize(), vtkEntry(range[0], range[1])));
}

std::vector<double> vtkSMProposedRangeDomain::ComputeProposedValues()
{
  std::vector<double> values;
  for (unsigned int i = 0; i < this->GetNumberOfEntries(); ++i)
  {
    const double lower = this->GetMinimum(i);
    const double upper = this->GetMaximum(i);
    const DefaultModes mode = this->GetDefaultMode(i);
    const double sum = lower + upper;
    const double center = std::isfinite(sum) ? sum / 2 : lower / 2 + upper / 2;
    values.push_back(mode == MIN ? lower : mode == MAX ? upper : center);
  }
  return values;
}

bool vtkSMProposedRangeDomain::IsAwaitingApply()
{
  return vtkPropertyPush::IsPending(this->GetRequiredProperty("ArraySelection"));
}

void vtkSMProposedRangeDomain::Update(vtkSMProperty*)
{
  const vtkArraySelection selection = vtkArraySelection::Find(this);
  if (!selection.IsComplete())
  {
    return;
  }
  const bool isNewSelection = !(selection == this->LastSelection);
  const std::vector<double> previousValues = this->ComputeProposedValues();
  if (isNewSelection)
  {
    this->LastSelection = selection;
    this->RangeOverTime[0] = 1.0;
    this->RangeOverTime[1] = 0.0;
  }
  double range[2];
  if (!this->FindRange(selection, false, range))
  {
    this->SetEntries(std::vector<vtkEntry>());
    return;
  }
  if (this->RangeOverTime[0] <= this->RangeOverTime[1])
  {
    range[0] = std::min(range[0], this->RangeOverTime[0]);
    range[1] = std::max(range[1], this->RangeOverTime[1]);
  }
  this->SetRange(range);
  vtkSMProperty* property = this->GetProperty();
  const bool isPending = this->IsAwaitingApply();
  if (isNewSelection && property &&
    (HasValues(property, isPending, this->Proposed) ||
      HasValues(property, isPending, previousValues)))
  {
    this->SetDefaultValues(property, isPending);
    if (!isPending)
    {
      vtkPropertyPush::Push(property);
    }
  }
}

int vtkSMProposedRangeDomain::SetDefaultValues(vtkSMProperty* property, bool useUnchecked)
{
  const vtkArraySelection selection = vtkArraySelection::Find(this);
  double range[2];
  if (this->AllTimeSteps && selection.IsComplete() && this->CanReadAllTimeSteps(selection) &&
    this->FindRange(selection, true, range))
  {
    this->LastSelection = selection;
    std::copy_n(range, 2, this->RangeOverTime);
    this->SetRange(range);
  }
  const std::vector<double> values = this->ComputeProposedValues();
  if (values.empty())
  {
    return 0;
  }
  this->Proposed = values;
  vtkSMPropertyHelper helper(property);
  helper.SetUseUnchecked(useUnchecked);
  helper.Set(values.data(), static_cast<unsigned int>(values.size()));
  return 1;
}

void vtkSMProposedRangeDomain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "AllTimeSteps: " << this->AllTimeSteps << "\n";
}

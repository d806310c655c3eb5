// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMCompleteRowsDomain.h"

#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkSMProxy.h"
#include "vtkSMVectorProperty.h"

vtkStandardNewMacro(vtkSMCompleteRowsDomain);

vtkSMCompleteRowsDomain::vtkSMCompleteRowsDomain() = default;
vtkSMCompleteRowsDomain::~vtkSMCompleteRowsDomain() = default;

int vtkSMCompleteRowsDomain::ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element)
{
  // The property has no parent proxy yet, so start observing the proxy when the property is first
  // modified.
  property->AddObserver(vtkCommand::ModifiedEvent, this, &vtkSMCompleteRowsDomain::ObserveUpdates);
  return this->Superclass::ReadXMLAttributes(property, element);
}

void vtkSMCompleteRowsDomain::ObserveUpdates()
{
  vtkSMProxy* proxy = this->GetProperty() ? this->GetProperty()->GetParent() : nullptr;
  if (proxy && !this->IsObserving)
  {
    this->IsObserving = true;
    proxy->AddObserver(vtkCommand::UpdateEvent, this, &vtkSMCompleteRowsDomain::WarnIfIncomplete);
    proxy->AddObserver(
      vtkCommand::UpdatePropertyEvent, this, &vtkSMCompleteRowsDomain::WarnIfIncomplete);
  }
}

void vtkSMCompleteRowsDomain::WarnIfIncomplete()
{
  vtkSMVectorProperty* property = vtkSMVectorProperty::SafeDownCast(this->GetProperty());
  if (!property || property->GetNumberOfElementsPerCommand() < 1)
  {
    return;
  }
  const unsigned int row = property->GetNumberOfElementsPerCommand();
  const unsigned int number = property->GetNumberOfElements();
  if (number % row != 0 && number != this->LastIncompleteSize)
  {
    vtkWarningMacro("The last row of " << property->GetXMLLabel() << " has only " << number % row
                                       << " of its " << row
                                       << " values and is ignored. Fill in the whole row.");
  }
  this->LastIncompleteSize = number % row == 0 ? 0 : number;
}

void vtkSMCompleteRowsDomain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

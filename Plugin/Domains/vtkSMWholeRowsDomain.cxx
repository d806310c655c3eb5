// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMWholeRowsDomain.h"

#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkSMProxy.h"
#include "vtkSMVectorProperty.h"

vtkStandardNewMacro(vtkSMWholeRowsDomain);

vtkSMWholeRowsDomain::vtkSMWholeRowsDomain() = default;
vtkSMWholeRowsDomain::~vtkSMWholeRowsDomain() = default;

int vtkSMWholeRowsDomain::ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element)
{
  // The proxy is not known yet.
  property->AddObserver(vtkCommand::ModifiedEvent, this, &vtkSMWholeRowsDomain::Watch);
  return this->Superclass::ReadXMLAttributes(property, element);
}

void vtkSMWholeRowsDomain::Watch()
{
  vtkSMProxy* proxy = this->GetProperty() ? this->GetProperty()->GetParent() : nullptr;
  if (proxy && !this->IsWatching)
  {
    this->IsWatching = true;
    proxy->AddObserver(vtkCommand::UpdateEvent, this, &vtkSMWholeRowsDomain::Check);
    proxy->AddObserver(vtkCommand::UpdatePropertyEvent, this, &vtkSMWholeRowsDomain::Check);
  }
}

void vtkSMWholeRowsDomain::Check()
{
  vtkSMVectorProperty* property = vtkSMVectorProperty::SafeDownCast(this->GetProperty());
  if (!property || property->GetNumberOfElementsPerCommand() < 1)
  {
    return;
  }
  const unsigned int row = property->GetNumberOfElementsPerCommand();
  const unsigned int number = property->GetNumberOfElements();
  if (number % row != 0 && number != this->SaidOf)
  {
    vtkWarningMacro("The last row of " << property->GetXMLLabel() << " has " << number % row
                                       << " of " << row << " values, and is left out.");
  }
  this->SaidOf = number % row == 0 ? 0 : number;
}

void vtkSMWholeRowsDomain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMAutoOffDomain.h"

#include "vtkObjectFactory.h"
#include "vtkPropertyPush.h"
#include "vtkSMDoubleVectorProperty.h"
#include "vtkSMPropertyHelper.h"

#include <limits>

vtkStandardNewMacro(vtkSMAutoOffDomain);

vtkSMAutoOffDomain::vtkSMAutoOffDomain() = default;
vtkSMAutoOffDomain::~vtkSMAutoOffDomain() = default;

void vtkSMAutoOffDomain::Update(vtkSMProperty*)
{
  auto* value = vtkSMDoubleVectorProperty::SafeDownCast(this->GetRequiredProperty("Value"));
  vtkSMProperty* toggle = this->GetProperty();
  if (!value || !toggle)
  {
    return;
  }
  if (!this->HasLastValue)
  {
    this->HasLastValue = true;
    this->LastValue = value->IsValueDefault() ? vtkSMPropertyHelper(value).GetAsDouble()
                                              : std::numeric_limits<double>::quiet_NaN();
  }
  vtkSMPropertyHelper shownValue(value);
  shownValue.SetUseUnchecked(true);
  if (shownValue.GetAsDouble() == this->LastValue)
  {
    return;
  }
  this->LastValue = shownValue.GetAsDouble();
  const bool isPending = vtkPropertyPush::IsPending(value);
  vtkSMPropertyHelper toggleHelper(toggle);
  toggleHelper.SetUseUnchecked(isPending);
  if (toggleHelper.GetAsInt() != 0)
  {
    toggleHelper.Set(0);
    if (!isPending)
    {
      vtkPropertyPush::Push(toggle);
    }
  }
}

void vtkSMAutoOffDomain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LastValue: " << this->LastValue << "\n";
}

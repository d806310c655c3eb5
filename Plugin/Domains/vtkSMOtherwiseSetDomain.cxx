// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMOtherwiseSetDomain.h"

#include "vtkObjectFactory.h"
#include "vtkPropertyPush.h"
#include "vtkSMDoubleVectorProperty.h"
#include "vtkSMPropertyHelper.h"

#include <limits>

vtkStandardNewMacro(vtkSMOtherwiseSetDomain);

vtkSMOtherwiseSetDomain::vtkSMOtherwiseSetDomain() = default;
vtkSMOtherwiseSetDomain::~vtkSMOtherwiseSetDomain() = default;

void vtkSMOtherwiseSetDomain::Update(vtkSMProperty*)
{
  auto* value = vtkSMDoubleVectorProperty::SafeDownCast(this->GetRequiredProperty("Value"));
  vtkSMProperty* own = this->GetProperty();
  if (!value || !own)
  {
    return;
  }
  if (!this->IsKnown)
  {
    this->IsKnown = true;
    this->Known = value->IsValueDefault() ? vtkSMPropertyHelper(value).GetAsDouble()
                                          : std::numeric_limits<double>::quiet_NaN();
  }
  vtkSMPropertyHelper shown(value);
  shown.SetUseUnchecked(true);
  if (shown.GetAsDouble() == this->Known)
  {
    return;
  }
  this->Known = shown.GetAsDouble();
  const bool isPending = vtkPropertyPush::IsPending(value);
  vtkSMPropertyHelper helper(own);
  helper.SetUseUnchecked(isPending);
  if (helper.GetAsInt() != 0)
  {
    helper.Set(0);
    if (!isPending)
    {
      vtkPropertyPush::Push(own);
    }
  }
}

void vtkSMOtherwiseSetDomain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Known: " << this->Known << "\n";
}

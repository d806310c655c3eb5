// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPropertyPush.h"

#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkVariant.h"

bool vtkPropertyPush::IsPending(vtkSMProperty* property)
{
  vtkSMPropertyHelper applied(property, /*quiet=*/true);
  vtkSMPropertyHelper shown(property, /*quiet=*/true);
  shown.SetUseUnchecked(true);
  const unsigned int number = applied.GetNumberOfElements();
  if (shown.GetNumberOfElements() != number)
  {
    return true;
  }
  for (unsigned int i = 0; i < number; ++i)
  {
    if (shown.GetAsVariant(i) != applied.GetAsVariant(i))
    {
      return true;
    }
  }
  return false;
}

void vtkPropertyPush::Push(vtkSMProperty* property)
{
  vtkSMProxy* proxy = property->GetParent();
  const char* name =
    proxy && proxy->GetObjectsCreated() ? proxy->GetPropertyName(property) : nullptr;
  if (name)
  {
    proxy->UpdateProperty(name);
  }
}

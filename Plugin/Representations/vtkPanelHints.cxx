#include "vtkPanelHints.h"

#include "vtkNew.h"
#include "vtkPVXMLElement.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMProxy.h"

#include <cstring>
#include <string>

namespace
{
/// Adds a decorator that hides \a item, a property or a group, for the type. All of an item's
/// decorators must agree to show it. The hints of others, which it may share, stay as they are.
template <typename Item>
void HideItem(Item* item, const char* type)
{
  vtkNew<vtkPVXMLElement> hints;
  hints->SetName("Hints");
  if (item->GetHints())
  {
    item->GetHints()->CopyAttributesTo(hints);
    for (unsigned int i = 0; i < item->GetHints()->GetNumberOfNestedElements(); ++i)
    {
      hints->AddNestedElement(item->GetHints()->GetNestedElement(i), 0);
    }
  }
  vtkNew<vtkPVXMLElement> decorator;
  decorator->SetName("PropertyWidgetDecorator");
  decorator->AddAttribute("type", "GenericDecorator");
  decorator->AddAttribute("mode", "visibility");
  decorator->AddAttribute("property", "Representation");
  decorator->AddAttribute("value", type);
  decorator->AddAttribute("inverse", "1");
  hints->AddNestedElement(decorator);
  item->SetHints(hints);
}
}

//------------------------------------------------------------------------------
void vtkPanelHints::Hide(vtkSMProxy* display, const char* type, vtkPVXMLElement* hidden)
{
  for (unsigned int i = 0; i < hidden->GetNumberOfNestedElements(); ++i)
  {
    vtkPVXMLElement* element = hidden->GetNestedElement(i);
    const std::string kind = element->GetName();
    if (kind == "Property")
    {
      if (vtkSMProperty* property = display->GetProperty(element->GetAttributeOrEmpty("name")))
      {
        HideItem(property, type);
      }
    }
    else if (kind == "Group")
    {
      for (std::size_t g = 0; g < display->GetNumberOfPropertyGroups(); ++g)
      {
        vtkSMPropertyGroup* group = display->GetPropertyGroup(g);
        if (group->GetXMLLabel() &&
          std::strcmp(group->GetXMLLabel(), element->GetAttributeOrEmpty("label")) == 0)
        {
          HideItem(group, type);
        }
      }
    }
  }
}

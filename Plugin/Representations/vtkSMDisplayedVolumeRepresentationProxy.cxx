// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMDisplayedVolumeRepresentationProxy.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVDataInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"

#include <cstring>
#include <iterator>
#include <set>
#include <sstream>
#include <vector>

vtkStandardNewMacro(vtkSMDisplayedVolumeRepresentationProxy);

namespace
{
/// Adds a decorator that hides a property or group while the representation \a type is selected. An
/// item is shown only if all of its decorators show it. The hints of the item are copied first,
/// because other items may share them.
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

/// Hides the properties of a group, except those named in \a exceptionNames.
void HideGroup(vtkSMPropertyGroup* group, const char* type, const char* exceptionNames)
{
  std::istringstream names(exceptionNames);
  const std::set<std::string> exceptions{ std::istream_iterator<std::string>(names), {} };
  if (exceptions.empty())
  {
    HideItem(group, type);
    return;
  }
  for (unsigned int i = 0; i < group->GetNumberOfProperties(); ++i)
  {
    if (exceptions.count(group->GetPropertyName(i)) == 0)
    {
      HideItem(group->GetProperty(i), type);
    }
  }
}

/// Hides parts of the panel of \a display while the representation \a type is selected. \a hidden
/// contains a `Property` with a `name` for each property to hide, and a `Group` with a `label` for
/// each group. The properties in the attribute `except` of a group remain visible. Other displays
/// are not affected.
void HideParts(vtkSMProxy* display, const char* type, vtkPVXMLElement* hidden)
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
          HideGroup(group, type, element->GetAttributeOrEmpty("except"));
        }
      }
    }
  }
}
}

vtkSMDisplayedVolumeRepresentationProxy::vtkSMDisplayedVolumeRepresentationProxy() = default;

vtkSMDisplayedVolumeRepresentationProxy::~vtkSMDisplayedVolumeRepresentationProxy() = default;

void vtkSMDisplayedVolumeRepresentationProxy::CreateVTKObjects()
{
  const bool areCreated = this->ObjectsCreated != 0;
  this->Superclass::CreateVTKObjects();
  vtkSMProxy* display = vtkSMPVRepresentationProxy::SafeDownCast(this->GetParentProxy());
  vtkPVXMLElement* volume =
    this->GetHints() ? this->GetHints()->FindNestedElementByName("Volume") : nullptr;
  if (areCreated || !this->ObjectsCreated || !display || !volume)
  {
    return;
  }
  this->Type = volume->GetAttributeOrEmpty("type");
  if (vtkPVXMLElement* hidden = this->GetHints()->FindNestedElementByName("Hidden"))
  {
    HideParts(display, this->Type.c_str(), hidden);
  }
  display->AddObserver(
    vtkCommand::UpdateEvent, this, &vtkSMDisplayedVolumeRepresentationProxy::DisplayChanged);
  display->AddObserver(
    vtkCommand::UpdateDataEvent, this, &vtkSMDisplayedVolumeRepresentationProxy::DisplayChanged);
}

void vtkSMDisplayedVolumeRepresentationProxy::DisplayChanged()
{
  auto* display = vtkSMPVRepresentationProxy::SafeDownCast(this->GetParentProxy());
  if (!this->IsFollowing && display)
  {
    this->IsFollowing = true;
    this->FollowDisplay(display);
    this->IsFollowing = false;
  }
}

void vtkSMDisplayedVolumeRepresentationProxy::SetValidSizes(vtkSMPVRepresentationProxy* display)
{
  std::vector<vtkSMProperty*> sizes;
  for (const char* name : { "GaussianRadius", "ScaleFactor" })
  {
    vtkSMProperty* property = display->GetProperty(name);
    if (property &&
      (vtkSMPropertyHelper(property).GetAsDouble() < 0.0 ||
        (this->HasDefaultSizes && property->IsValueDefault())))
    {
      sizes.push_back(property);
    }
  }
  const vtkSMPropertyHelper input(display, "Input");
  auto* source = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  if (sizes.empty() || !source)
  {
    return;
  }
  // Until there are data, use the defaults of the XML.
  this->HasDefaultSizes =
    source->GetDataInformation(input.GetOutputPort())->GetNumberOfPoints() == 0;
  for (vtkSMProperty* property : sizes)
  {
    if (this->HasDefaultSizes || !property->ResetToDomainDefaults())
    {
      property->ResetToXMLDefaults();
    }
  }
  display->UpdateVTKObjects();
}

void vtkSMDisplayedVolumeRepresentationProxy::FollowDisplay(vtkSMPVRepresentationProxy* display)
{
  this->SetValidSizes(display);
  // Since ParaView 5.12, this property of the display is named Translation. Earlier versions name
  // it Position, and share it with this representation automatically.
  vtkSMProperty* translation = display->GetProperty("Translation");
  if (translation)
  {
    this->GetProperty("Position")->Copy(translation);
    this->UpdateVTKObjects();
  }
}

void vtkSMDisplayedVolumeRepresentationProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Type: " << this->Type << "\n";
}

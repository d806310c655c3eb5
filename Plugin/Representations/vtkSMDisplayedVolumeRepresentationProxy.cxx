// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMDisplayedVolumeRepresentationProxy.h"

#include "vtkPanelHints.h"

#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkPVXMLElement.h"
#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMProperty.h"

vtkStandardNewMacro(vtkSMDisplayedVolumeRepresentationProxy);

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
    vtkPanelHints::Hide(display, this->Type.c_str(), hidden);
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

void vtkSMDisplayedVolumeRepresentationProxy::FollowDisplay(vtkSMPVRepresentationProxy* display)
{
  // From ParaView 5.12 on a display calls Translation where it has the data; what it calls
  // Position before reaches the representation by itself.
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

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLitVolumeRepresentation.h"

#include "vtkAreaLight.h"
#include "vtkProjectiveLight.h"
#include "vtkTextureImage.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkTexture.h"

vtkStandardNewMacro(vtkLitVolumeRepresentation);

namespace
{
// A light with a cone angle of 90 degrees or more has no cone.
constexpr double NoCone = 180.0;
}

vtkLitVolumeRepresentation::vtkLitVolumeRepresentation()
  : ProjectiveLight(vtkSmartPointer<vtkProjectiveLight>::New())
{
  this->SetAreaLight(vtkNew<vtkAreaLight>());
}

vtkLitVolumeRepresentation::~vtkLitVolumeRepresentation() = default;

void vtkLitVolumeRepresentation::SetProjectiveLight(vtkProjectiveLight* light)
{
  this->ProjectiveLight = light;
  this->UpdateLights();
}

void vtkLitVolumeRepresentation::SetAreaLight(vtkAreaLight* light)
{
  this->AreaLight = light;
  this->AreaLight->SetConeAngle(NoCone);
  this->UpdateLights();
}

void vtkLitVolumeRepresentation::SetProjectiveLightSwitch(bool on)
{
  this->ProjectiveLightSwitch = on;
  this->UpdateLights();
}

void vtkLitVolumeRepresentation::SetAreaLightSwitch(bool on)
{
  this->AreaLightSwitch = on;
  this->UpdateLights();
}

void vtkLitVolumeRepresentation::SetProjectiveLightScreenWidth(double width)
{
  this->ProjectiveLight->SetScreenSize(width, this->ProjectiveLight->GetScreenSize()[1]);
}

void vtkLitVolumeRepresentation::SetProjectiveLightScreenHeight(double height)
{
  this->ProjectiveLight->SetScreenSize(this->ProjectiveLight->GetScreenSize()[0], height);
}

void vtkLitVolumeRepresentation::SetProjectiveLightImage(vtkTexture* texture)
{
  this->ProjectiveLightImage = texture;
}

void vtkLitVolumeRepresentation::SetAreaLightWidth(double width)
{
  // ParaView proposes a negative length for data without bounds.
  if (!(width < 0.0))
  {
    this->AreaLight->SetSize(width, this->AreaLight->GetSize()[1]);
  }
}

void vtkLitVolumeRepresentation::SetAreaLightHeight(double height)
{
  if (!(height < 0.0))
  {
    this->AreaLight->SetSize(this->AreaLight->GetSize()[0], height);
  }
}

void vtkLitVolumeRepresentation::SetAreaLightImage(vtkTexture* texture)
{
  this->AreaLightImage = texture;
}

void vtkLitVolumeRepresentation::SetVisibility(bool visible)
{
  this->Superclass::SetVisibility(visible);
  this->UpdateLights();
}

void vtkLitVolumeRepresentation::UpdateLights()
{
  // Other representations would be lit by a light that this one skips.
  const std::string screenError = this->ProjectiveLight->GetImageError();
  const std::string emitterError = this->AreaLight->GetEmitterError();
  const bool isVisible = this->GetVisibility();
  this->ProjectiveLight->SetSwitch(this->ProjectiveLightSwitch && isVisible && screenError.empty());
  this->AreaLight->SetSwitch(this->AreaLightSwitch && isVisible && emitterError.empty());
  std::string error;
  if (this->ProjectiveLightSwitch && !screenError.empty())
  {
    error =
      "The projective light is off, because " + screenError + ". Select another Screen Image.";
  }
  else if (this->AreaLightSwitch && !emitterError.empty())
  {
    error = "The area light is off, because " + emitterError + ". Select another Light Image.";
  }
  if (error != this->LightError)
  {
    this->LightError = error;
    if (!error.empty())
    {
      vtkErrorMacro(<< error);
    }
  }
  this->LightsUpdated();
}

bool vtkLitVolumeRepresentation::IsAreaLightOn() const
{
  return this->AreaLight->GetSwitch() != 0;
}

bool vtkLitVolumeRepresentation::AddToView(vtkView* view)
{
  if (!this->Superclass::AddToView(view))
  {
    return false;
  }
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  renderView->AddLight(this->ProjectiveLight);
  renderView->AddLight(this->AreaLight);
  return true;
}

bool vtkLitVolumeRepresentation::RemoveFromView(vtkView* view)
{
  if (auto* renderView = vtkPVRenderView::SafeDownCast(view))
  {
    renderView->RemoveLight(this->ProjectiveLight);
    renderView->RemoveLight(this->AreaLight);
  }
  return this->Superclass::RemoveFromView(view);
}

void vtkLitVolumeRepresentation::UpdateMapperParameters()
{
  this->Superclass::UpdateMapperParameters();
  this->ProjectiveLight->SetImage(vtkTextureImage(this->ProjectiveLightImage));
  this->AreaLight->SetEmitter(vtkTextureImage(this->AreaLightImage));
  this->UpdateLights();
}

void vtkLitVolumeRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ProjectiveLight: " << this->ProjectiveLightSwitch << "\n";
  this->ProjectiveLight->PrintSelf(os, indent.GetNextIndent());
  os << indent << "AreaLight: " << this->AreaLightSwitch << "\n";
  this->AreaLight->PrintSelf(os, indent.GetNextIndent());
}

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLitVolumeRepresentation.h"

#include "vtkAreaLight.h"
#include "vtkProjectiveLight.h"
#include "vtkTextureImage.h"

#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkTexture.h"

vtkStandardNewMacro(vtkLitVolumeRepresentation);

namespace
{
// Of 90 degrees and more a light has no cone.
constexpr double NoCone = 180.0;
}

vtkLitVolumeRepresentation::vtkLitVolumeRepresentation()
{
  this->Lamp->SetConeAngle(NoCone);
  this->UpdateLights();
}

vtkLitVolumeRepresentation::~vtkLitVolumeRepresentation() = default;

void vtkLitVolumeRepresentation::SetProjectiveLight(bool shines)
{
  this->ProjectorShines = shines;
  this->UpdateLights();
}

void vtkLitVolumeRepresentation::SetProjectiveLightPositional(bool positional)
{
  this->Projector->SetPositional(positional);
}

void vtkLitVolumeRepresentation::SetProjectiveLightPosition(double x, double y, double z)
{
  this->Projector->SetPosition(x, y, z);
}

void vtkLitVolumeRepresentation::SetProjectiveLightFocalPoint(double x, double y, double z)
{
  this->Projector->SetFocalPoint(x, y, z);
}

void vtkLitVolumeRepresentation::SetProjectiveLightViewUp(double x, double y, double z)
{
  this->Projector->SetViewUp(x, y, z);
}

void vtkLitVolumeRepresentation::SetProjectiveLightScreenWidth(double width)
{
  this->Projector->SetScreenSize(width, this->Projector->GetScreenSize()[1]);
}

void vtkLitVolumeRepresentation::SetProjectiveLightScreenHeight(double height)
{
  this->Projector->SetScreenSize(this->Projector->GetScreenSize()[0], height);
}

void vtkLitVolumeRepresentation::SetProjectiveLightEdgeWidth(double width)
{
  this->Projector->SetEdgeWidth(width);
}

void vtkLitVolumeRepresentation::SetProjectiveLightColor(double red, double green, double blue)
{
  this->Projector->SetColor(red, green, blue);
}

void vtkLitVolumeRepresentation::SetProjectiveLightIntensity(double intensity)
{
  this->Projector->SetIntensity(intensity);
}

void vtkLitVolumeRepresentation::SetProjectiveLightImage(vtkTexture* texture)
{
  this->ProjectorImage = texture;
}

void vtkLitVolumeRepresentation::SetProjectiveLightShadows(bool shadows)
{
  this->Projector->SetShadowAttenuation(shadows ? 1.0f : 0.0f);
}

void vtkLitVolumeRepresentation::SetAreaLight(bool shines)
{
  this->LampShines = shines;
  this->UpdateLights();
}

void vtkLitVolumeRepresentation::SetAreaLightPositional(bool positional)
{
  this->Lamp->SetPositional(positional);
}

void vtkLitVolumeRepresentation::SetAreaLightShape(int shape)
{
  this->Lamp->SetShape(shape);
}

void vtkLitVolumeRepresentation::SetAreaLightPosition(double x, double y, double z)
{
  this->Lamp->SetPosition(x, y, z);
}

void vtkLitVolumeRepresentation::SetAreaLightFocalPoint(double x, double y, double z)
{
  this->Lamp->SetFocalPoint(x, y, z);
}

void vtkLitVolumeRepresentation::SetAreaLightViewUp(double x, double y, double z)
{
  this->Lamp->SetViewUp(x, y, z);
}

void vtkLitVolumeRepresentation::SetAreaLightWidth(double width)
{
  this->Lamp->SetSize(width, this->Lamp->GetSize()[1]);
}

void vtkLitVolumeRepresentation::SetAreaLightHeight(double height)
{
  this->Lamp->SetSize(this->Lamp->GetSize()[0], height);
}

void vtkLitVolumeRepresentation::SetAreaLightColor(double red, double green, double blue)
{
  this->Lamp->SetColor(red, green, blue);
}

void vtkLitVolumeRepresentation::SetAreaLightIntensity(double intensity)
{
  this->Lamp->SetIntensity(intensity);
}

void vtkLitVolumeRepresentation::SetAreaLightImage(vtkTexture* texture)
{
  this->LampImage = texture;
}

void vtkLitVolumeRepresentation::SetAreaLightShadows(bool shadows)
{
  this->Lamp->SetShadowAttenuation(shadows ? 1.0f : 0.0f);
}

void vtkLitVolumeRepresentation::SetVisibility(bool visible)
{
  this->Superclass::SetVisibility(visible);
  this->UpdateLights();
}

void vtkLitVolumeRepresentation::UpdateLights()
{
  this->Projector->SetSwitch(this->ProjectorShines && this->GetVisibility());
  this->Lamp->SetSwitch(this->LampShines && this->GetVisibility());
}

bool vtkLitVolumeRepresentation::AddToView(vtkView* view)
{
  if (!this->Superclass::AddToView(view))
  {
    return false;
  }
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  renderView->AddLight(this->Projector);
  renderView->AddLight(this->Lamp);
  return true;
}

bool vtkLitVolumeRepresentation::RemoveFromView(vtkView* view)
{
  if (auto* renderView = vtkPVRenderView::SafeDownCast(view))
  {
    renderView->RemoveLight(this->Projector);
    renderView->RemoveLight(this->Lamp);
  }
  return this->Superclass::RemoveFromView(view);
}

void vtkLitVolumeRepresentation::UpdateMapperParameters()
{
  this->Superclass::UpdateMapperParameters();
  this->Projector->SetImage(vtkTextureImage(this->ProjectorImage));
  this->Lamp->SetEmitter(vtkTextureImage(this->LampImage));
}

void vtkLitVolumeRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ProjectiveLight: " << this->ProjectorShines << "\n";
  this->Projector->PrintSelf(os, indent.GetNextIndent());
  os << indent << "AreaLight: " << this->LampShines << "\n";
  this->Lamp->PrintSelf(os, indent.GetNextIndent());
}

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTemporaryAreaLights.h"

#include "vtkAreaLight.h"
#include "vtkLightList.h"
#include "vtkProjectiveLight.h"

#include "vtkMath.h"
#include "vtkRenderer.h"

#include <cmath>

void vtkTemporaryAreaLights::Begin(vtkRenderer* renderer, double angle, double scale)
{
  renderer->UpdateLightsGeometryToFollowCamera();
  this->Lights = vtkLightList::Get(renderer);
  std::map<vtkLight*, Copy> copies;
  std::vector<vtkSmartPointer<vtkLight>> newLights;
  for (const auto& light : this->Lights)
  {
    if (vtkProjectiveLight::SafeDownCast(light) || vtkAreaLight::SafeDownCast(light))
    {
      newLights.push_back(light);
      continue;
    }
    Copy copy = this->Copies[light];
    if (!copy.Light)
    {
      copy.Light = vtkSmartPointer<vtkAreaLight>::New();
    }
    if (copy.Time != light->GetMTime())
    {
      copy.Light->DeepCopy(light);
      copy.Time = light->GetMTime();
    }
    // Compute the size from world positions, because the size is in world units even if the light
    // has a transform matrix.
    double position[3];
    double focalPoint[3];
    light->GetTransformedPosition(position);
    light->GetTransformedFocalPoint(focalPoint);
    const double distance = std::sqrt(vtkMath::Distance2BetweenPoints(position, focalPoint));
    const double size = 2.0 * distance * std::tan(vtkMath::RadiansFromDegrees(0.5 * angle));
    copy.Light->SetSize(size, size);
    copy.Light->SetIntensity(scale * light->GetIntensity());
    copies[light] = copy;
    newLights.emplace_back(copy.Light);
  }
  this->Copies.swap(copies);
  vtkLightList::Set(renderer, newLights);
}

void vtkTemporaryAreaLights::End(vtkRenderer* renderer)
{
  if (!this->Lights.empty())
  {
    vtkLightList::Set(renderer, this->Lights);
    this->Lights.clear();
  }
}

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWidenedLights.h"

#include "vtkAreaLight.h"
#include "vtkLightList.h"
#include "vtkProjectiveLight.h"

#include "vtkMath.h"
#include "vtkRenderer.h"

#include <cmath>

void vtkWidenedLights::Begin(vtkRenderer* renderer, double angle)
{
  renderer->UpdateLightsGeometryToFollowCamera();
  this->Lights = vtkLightList::Get(renderer);
  std::map<vtkLight*, Copy> copies;
  std::vector<vtkSmartPointer<vtkLight>> widened;
  for (const auto& light : this->Lights)
  {
    if (vtkProjectiveLight::SafeDownCast(light) || vtkAreaLight::SafeDownCast(light))
    {
      widened.push_back(light);
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
    // The size of an area light is the world's, whatever transform its place has.
    double position[3];
    double focus[3];
    light->GetTransformedPosition(position);
    light->GetTransformedFocalPoint(focus);
    const double distance = std::sqrt(vtkMath::Distance2BetweenPoints(position, focus));
    const double size = 2.0 * distance * std::tan(vtkMath::RadiansFromDegrees(0.5 * angle));
    copy.Light->SetSize(size, size);
    copies[light] = copy;
    widened.emplace_back(copy.Light);
  }
  this->Copies.swap(copies);
  vtkLightList::Set(renderer, widened);
}

void vtkWidenedLights::End(vtkRenderer* renderer)
{
  if (!this->Lights.empty())
  {
    vtkLightList::Set(renderer, this->Lights);
    this->Lights.clear();
  }
}

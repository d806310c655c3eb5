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
    if (copy.Time != light->GetMTime() || copy.Angle != angle)
    {
      copy.Light->DeepCopy(light);
      const double distance =
        std::sqrt(vtkMath::Distance2BetweenPoints(light->GetPosition(), light->GetFocalPoint()));
      const double size = 2.0 * distance * std::tan(vtkMath::RadiansFromDegrees(0.5 * angle));
      copy.Light->SetSize(size, size);
      copy.Time = light->GetMTime();
      copy.Angle = angle;
    }
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

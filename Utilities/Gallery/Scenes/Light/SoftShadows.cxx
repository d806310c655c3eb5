// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Scenes/Light/SoftShadows.h"

#include "Gallery/Stage.h"

#include "vtkAreaLight.h"
#include "vtkNew.h"
#include "vtkShadowedSliceMapper.h"

namespace gallery
{
Lights MakeDiskLights(const Lights& lights, double diameter)
{
  Lights round;
  for (const vtkSmartPointer<vtkLight>& light : lights)
  {
    round.push_back(light);
    if (light->GetShadowAttenuation() > 0.0F)
    {
      vtkNew<vtkAreaLight> area;
      area->DeepCopy(light);
      area->SetShapeToRound();
      area->SetSize(diameter, diameter);
      round.back() = area;
    }
  }
  return round;
}

void SoftShadowPair::Look(const vtkVector3d& from, const vtkBoundingBox& frame) const
{
  ShadowPair{ this->Hard, this->Soft }.Look(from, frame);
}

void SoftShadowPair::SetBackground(const vtkColor3d& lower, const vtkColor3d& upper) const
{
  ShadowPair{ this->Hard, this->Soft }.SetBackground(lower, upper);
}

SoftShadowPair AddSoftShadowPair(Stage& stage, vtkImageData* image, vtkVolumeProperty* property,
  const Lights& lights, double diameter, double surfaceGradient, int lightBuffer)
{
  Panel& hard = stage.AddPanel("hard shadows");
  Panel& soft = stage.AddPanel("soft shadows");
  for (Panel* panel : { &hard, &soft })
  {
    vtkSmartPointer<vtkVolume> volume = MakeSlicedVolume(image, property, surfaceGradient);
    if (panel == &soft)
    {
      // Soft shadows need fewer texels than hard shadows, but enough light samples to avoid visible
      // steps.
      GetSlicedMapper(volume)->SetLightBufferSize(lightBuffer);
      GetSlicedMapper(volume)->SetNumberOfLightSamples(64);
    }
    panel->Add(volume);
    panel->SetLights(panel == &soft ? MakeDiskLights(lights, diameter) : lights);
  }
  return { hard, soft };
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Transport/CloudCase.h"

#include "Support/Inputs/Clouds.h"
#include "Support/Images/ShadowCases.h"

#include "vtkSpatialObject.h"

namespace reference
{

ShadowScene MakeCloudCase(int cells, int pixels)
{
  interlume::Cumulus cloud;
  cloud.Seed = 3;
  ShadowScene scene;
  scene.Image = interlume::SampleDensity(
    interlume::MakeClouds({ cloud }), { { -0.7, 0.7, -0.6, 0.6, -0.15, 0.95 } }, cells);
  scene.Property = interlume::MakeCloudProperty(30.0);
  scene.Lights = { MakeDirectionalLight({ { 0.6, -0.5, -0.6 } }) };
  scene.Lights.front()->SetIntensity(1.0);
  scene.Camera = LookAt(scene.Image, { { 0.1, 1.0, -0.1 } }, false);
  scene.Camera->SetViewUp(0.0, 0.0, 1.0);
  scene.Size = { { pixels, pixels } };
  return scene;
}

}

// SPDX-License-Identifier: BSD-3-Clause
// Polygonal mushrooms on bumpy ground that is a volume.

#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/SoftShadows.h"
#include "Gallery/Scenes/Mixed/ModelActors.h"
#include "Gallery/Stage.h"

#include "vtkNew.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkSpatialTurbulence.h"

namespace
{
using namespace interlume;

Model MakeMushrooms()
{
  Model all =
    Move(MakeMushroom(1.0, 0.48, 0.06), { { -0.12, 0.12, 0.0 } }, { { 0.0, 0.0, 200.0 } });
  Append(
    all, Move(MakeMushroom(0.64, 0.36, 0.18), { { 0.46, -0.2, 0.0 } }, { { 0.0, 0.0, -38.0 } }));
  return Append(
    all, Move(MakeMushroom(0.4, 0.2, 0.2), { { -0.5, -0.42, 0.0 } }, { { 0.0, 0.0, 215.0 } }));
}

vtkSmartPointer<vtkImageData> SampleGround()
{
  vtkNew<vtkSpatialTurbulence> ground;
  ground->SetOperand(gallery::MakeFloor({ 0.42, 0.50, 0.24 }, -0.03));
  ground->SetSum(vtkTurbulenceSource::FRACTAL_SUM);
  ground->SetNumberOfOctaves(4);
  ground->SetFrequency(3.0);
  ground->SetAmplitude(0.05);
  return gallery::Sample(ground, vtkBoundingBox(-1.95, 1.9, -1.6, 1.25, -0.12, 0.08), 300, 0.8);
}

/// Adds the polygonal mushrooms and the ground, a volume in \a image, with mutual shadows.
void AddMushrooms(
  gallery::Panel& panel, vtkImageData* image, const gallery::Lights& lights, int samples)
{
  vtkSmartPointer<vtkVolume> ground =
    gallery::MakeSlicedVolume(image, gallery::MakeSolidMedium(image));
  gallery::GetSlicedMapper(ground)->SetNumberOfLightSamples(samples);
  gallery::GetSlicedMapper(ground)->SetLightBufferSize(512);
  panel.Add(ground);
  gallery::AddModel(panel, MakeMushrooms(), gallery::EDGE_GAIN);
  gallery::UseSceneShadows(panel, samples);
  gallery::UseFullResolution(panel);
  panel.SetBackground({ 0.80, 0.86, 0.84 }, { 0.30, 0.44, 0.46 });
  panel.SetLights(lights);
  panel.LookFrom({ 0.1, -1.0, 0.5 }, { 0.0, 0.0, 1.0 });
}

gallery::Lights MakeLights()
{
  gallery::Lights lights = gallery::MakeStudioLights({ -1.6, -2.2, 3.6 }, 1.05);
  lights.back()->SetIntensity(0.45);
  return lights;
}

void Build(gallery::Stage& stage)
{
  gallery::Panel& panel = stage.AddPanel("");
  AddMushrooms(panel, SampleGround(), MakeLights(), 1);
  panel.Frame(vtkBoundingBox(-0.78, 1.0, -0.1, 0.1, -0.4, 1.04));
}

void BuildSoft(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> ground = SampleGround();
  for (const bool isSoft : { false, true })
  {
    gallery::Panel& panel = stage.AddPanel(isSoft ? "soft shadows" : "hard shadows");
    AddMushrooms(panel, ground, isSoft ? gallery::MakeDiskLights(MakeLights(), 1.0) : MakeLights(),
      isSoft ? 40 : 1);
    panel.Frame(vtkBoundingBox(-0.84, 0.98, -0.1, 0.1, -0.36, 1.06));
  }
}

const gallery::SceneRegistration registration({ "mushrooms", "2.43", "The shadows of mushrooms",
  "Three polygonal mushrooms on bumpy ground, which is a volume. Caps shade their own stems, and "
  "the "
  "shadows of all mushrooms follow the ground.",
  {}, &Build });
const gallery::SceneRegistration softRegistration(
  { "mushrooms-soft", "2.48", "Hard and soft shadows of mushrooms",
    "The same mushrooms under a point light and under a disk light. The shadows of the stems are "
    "sharp at their feet. The shadows of the caps widen with their height above the ground.",
    {}, &BuildSoft });
}

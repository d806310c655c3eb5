// SPDX-License-Identifier: BSD-3-Clause
// A scanned bonsai, without and with shadows.

#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/Bonsai.h"
#include "Gallery/Scenes/Light/SoftShadows.h"
#include "Gallery/Scenes/Mixed/ModelActors.h"
#include "Gallery/Stage.h"

#include "vtkActorCollection.h"
#include "vtkShadowedScenePass.h"

namespace
{
constexpr interlume::Position3 GROUND{ { 0.84, 0.76, 0.66 } };

/// Adds a polygonal ground to \a panel, in which surfaces and volumes shadow each other.
void AddShadedGround(gallery::Panel& panel, int samples)
{
  gallery::AddGround(panel, { { 0.0, 0.0, 0.0 } }, 2.0, gallery::EDGE_GAIN, GROUND);
  // The edge of the ground needs no shadow.
  vtkShadowedScenePass::SetCastsShadows(panel.GetRenderer()->GetActors()->GetLastActor(), false);
  gallery::UseSceneShadows(panel, samples);
  gallery::UseFullResolution(panel);
}

gallery::Lights MakeLights()
{
  gallery::Lights lights = gallery::MakeStudioLights({ -1.1, -1.9, 4.8 }, 0.88);
  lights.back()->SetIntensity(0.4);
  return lights;
}

void Build(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = gallery::SampleBonsai(240);
  gallery::ShadowPair pair =
    gallery::AddShadowPair(stage, image, gallery::MakeSolidMedium(image), MakeLights());
  AddShadedGround(pair.With, 1);
  gallery::AddGround(pair.Without, { { 0.0, 0.0, 0.0 } }, 2.0, 1.0, GROUND);
  pair.Without.SetAmbientOcclusion(0.0);
  gallery::UseFullResolution(pair.Without);
  pair.SetBackground({ 0.90, 0.90, 0.84 }, { 0.50, 0.60, 0.56 });
  pair.Look({ 0.1, -1.0, 0.4 }, vtkBoundingBox(-0.46, 0.66, -0.1, 0.1, -0.16, 1.06));
}

void BuildSoft(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = gallery::SampleBonsai(220);
  gallery::SoftShadowPair pair = gallery::AddSoftShadowPair(
    stage, image, gallery::MakeSolidMedium(image), MakeLights(), 0.9, 0.0, 640);
  AddShadedGround(pair.Hard, 1);
  AddShadedGround(pair.Soft, 48);
  pair.SetBackground({ 0.92, 0.88, 0.80 }, { 0.56, 0.50, 0.46 });
  pair.Look({ 0.1, -1.0, 0.5 }, vtkBoundingBox(-0.46, 0.66, -0.1, 0.1, -0.16, 1.06));
}

const gallery::SceneRegistration registration(
  { "bonsai", "2.14", "A bonsai, without and with shadows",
    "A scanned bonsai in its pot, colored by the scan value. Shadows add depth to the crown; it "
    "shades the trunk, the soil and the ground.",
    { "bonsai.vti" }, &Build });

const gallery::SceneRegistration softRegistration(
  { "bonsai-soft", "2.36", "A bonsai under a point light and under a disk light",
    "The scanned bonsai under a disk light. The shadow of the pot has a sharp edge; the shadow of "
    "the crown on the ground is soft.",
    { "bonsai.vti" }, &BuildSoft });
}

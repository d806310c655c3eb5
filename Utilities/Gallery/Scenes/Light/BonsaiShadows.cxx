// SPDX-License-Identifier: BSD-3-Clause
// A scanned bonsai, without and with shadows.

#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/Bonsai.h"
#include "Gallery/Scenes/Light/SoftShadows.h"
#include "Gallery/Stage.h"

namespace
{
vtkSmartPointer<vtkImageData> SampleBonsai()
{
  vtkSmartPointer<vtkSpatialObject> all =
    gallery::Unite({ gallery::MakeBonsai(), gallery::MakeFloor({ 0.78, 0.70, 0.60 }) });
  return gallery::Sample(all, vtkBoundingBox(-0.88, 1.05, -0.86, 0.84, -0.04, 1.08), 260, 0.5);
}

void Build(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = SampleBonsai();
  gallery::ShadowPair pair = gallery::AddShadowPair(stage, image, gallery::MakeSolidMedium(image),
    gallery::MakeStudioLights({ -0.9, -0.7, 5.0 }, 0.9));
  pair.UseBackdrop({ 0.90, 0.90, 0.84 }, { 0.50, 0.60, 0.56 });
  pair.Look({ 0.1, -1.0, 0.4 }, vtkBoundingBox(-0.54, 0.74, -0.1, 0.1, -0.12, 1.08));
}

void BuildSoft(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = SampleBonsai();
  gallery::SoftShadowPair pair =
    gallery::AddSoftShadowPair(stage, image, gallery::MakeSolidMedium(image),
      gallery::MakeStudioLights({ -0.9, -0.8, 4.6 }, 0.85), 1.1, 0.0, 640);
  pair.UseBackdrop({ 0.92, 0.88, 0.80 }, { 0.56, 0.50, 0.46 });
  pair.Look({ 0.1, -1.0, 0.5 }, vtkBoundingBox(-0.54, 0.76, -0.1, 0.1, -0.06, 1.08));
}

const gallery::SceneRegistration registration(
  { "bonsai", "2.14", "A bonsai, without and with shadows",
    "A scanned bonsai in its pot, colored by the scan value. Shadows add depth to the crown; it "
    "shades the trunk, the soil and the ground.",
    { "bonsai.vti" }, &Build });

const gallery::SceneRegistration softRegistration(
  { "bonsai-soft", "2.36", "A bonsai under a point light and under a disk light",
    "The scanned bonsai under a disk light. The shadow of the pot has a sharp edge; the shadow of "
    "the crown on the floor is soft.",
    { "bonsai.vti" }, &BuildSoft });
}

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
  vtkSmartPointer<vtkSpatialObject> all = gallery::Unite({ gallery::MakeBonsai(),
    gallery::MakeDisk({ 0.0, -0.05, 0.0 }, 0.68, 0.05, gallery::Plaster()) });
  return gallery::Sample(all, vtkBoundingBox(-0.7, 0.7, -0.75, 0.65, -0.07, 1.1), 216, 0.5);
}

void Build(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = SampleBonsai();
  gallery::ShadowPair pair = gallery::AddShadowPair(stage, image, gallery::MakeSolidMedium(image),
    gallery::MakeStudioLights({ -1.8, -1.4, 3.2 }, 0.85));
  pair.Look({ 0.1, -1.0, 0.4 }, vtkBoundingBox(-0.66, 0.66, -0.1, 0.1, -0.27, 1.06));
}

void BuildSoft(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = SampleBonsai();
  gallery::AddSoftPair(stage, image, gallery::MakeSolidMedium(image),
    gallery::MakeStudioLights({ -1.8, -1.4, 3.2 }, 0.85), 0.9)
    .Look({ 0.1, -1.0, 0.5 }, vtkBoundingBox(-0.66, 0.66, -0.1, 0.1, -0.33, 1.04));
}

const gallery::SceneRegistration registration(
  { "bonsai", "2.14", "A bonsai, without and with shadows",
    "A scanned bonsai in its pot, colored by the scan value. Shadows add depth to the crown; it "
    "shades the trunk, the soil and the ground.",
    { "bonsai.vti" }, &Build });

const gallery::SceneRegistration softRegistration(
  { "bonsai-soft", "2.36", "A bonsai under a point light and under a disk light",
    "The scanned bonsai under a disk light. The shadow of the pot has a sharp edge; the shadow of "
    "the crown on the plate is soft.",
    { "bonsai.vti" }, &BuildSoft });
}

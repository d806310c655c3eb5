// SPDX-License-Identifier: BSD-3-Clause
// A sphere displaced by turbulence, and its shadow.

#include "Gallery/Panel.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Gallery/Scenes/Light/SoftShadows.h"
#include "Gallery/Stage.h"

#include "vtkConstructiveModels.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkSpatialObject.h"
#include "vtkSpatialPrimitive.h"
#include "vtkVolumeProperty.h"

namespace
{
vtkSmartPointer<vtkImageData> SampleSphere()
{
  vtkSmartPointer<vtkSpatialObject> all = gallery::Unite(
    { gallery::Place(vtkConstructiveModels::MakeHypertextureSphere(), { 0.0, 0.0, 0.62 }),
      gallery::MakeDisk({ 0.0, 0.0, 0.0 }, 1.0, 0.05, gallery::Plaster()) });
  return gallery::Sample(all, vtkBoundingBox(-1.05, 1.05, -1.05, 1.05, -0.1, 1.35), 170, 0.7);
}

void Build(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = SampleSphere();
  gallery::Panel& panel = gallery::AddShadowPanel(
    stage, image, gallery::MakeSolidMatter(image), gallery::MakeStudioLights({ -2.4, -1.4, 3.0 }));
  panel.LookFrom({ 0.15, -1.0, 0.5 }, { 0.0, 0.0, 1.0 });
  panel.Frame(vtkBoundingBox(-1.0, 1.0, -0.1, 0.1, -0.62, 1.35));
}

void BuildSoft(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = SampleSphere();
  gallery::AddSoftPair(stage, image, gallery::MakeSolidMatter(image),
    gallery::MakeStudioLights({ -2.4, -1.4, 3.0 }), 1.0)
    .Look({ 0.15, -1.0, 0.55 }, vtkBoundingBox(-0.98, 0.98, -0.1, 0.1, -0.58, 1.32));
}

const gallery::SceneRegistration registration(
  { "hypertexture", "2.12", "A hypertextured sphere with its shadow",
    "A sphere whose surface is displaced by a sum of octaves of noise. Its bulges shade its "
    "hollows, and its ragged outline returns in the shadow on the disk.",
    {}, &Build });

const gallery::SceneRegistration softRegistration({ "hypertexture-soft", "2.37",
  "A hypertextured sphere in the light of a point and of a disk",
  "The light of a disk reaches round the bulges, and the ragged outline of the shadow on the plate "
  "melts with its distance from the sphere.",
  {}, &BuildSoft });
}

// SPDX-License-Identifier: BSD-3-Clause
// The shadow of a sphere on a sphere, without and with shadows.

#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Gallery/Stage.h"

#include "vtkConstructiveModels.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkSpatialObject.h"
#include "vtkSpatialPrimitive.h"
#include "vtkVolumeProperty.h"

namespace
{
void Build(gallery::Stage& stage)
{
  vtkSmartPointer<vtkSpatialObject> all =
    gallery::Unite({ gallery::Place(gallery::Soften(vtkConstructiveModels::MakeTwoSpheres()),
                       { 0.0, 0.0, 0.5 }, -60.0),
      gallery::MakeDisk({ 0.0, 0.0, 0.0 }, 0.85, 0.05, gallery::Plaster()) });
  vtkSmartPointer<vtkImageData> image =
    gallery::Sample(all, vtkBoundingBox(-0.9, 0.9, -0.9, 0.9, -0.1, 1.35), 160);
  gallery::ShadowPair pair = gallery::AddShadowPair(stage, image, gallery::MakeSolidMatter(image),
    gallery::MakeStudioLights({ -1.9, -2.3, 3.2 }, 0.9));
  pair.Look({ 0.2, -1.0, 0.75 }, vtkBoundingBox(-0.84, 0.84, -0.1, 0.1, -0.4, 1.3));
}

const gallery::SceneRegistration registration(
  { "curved-shadows", "2.11", "Curved shadows on curved objects, without and with shadows",
    "A small sphere is joined to a large one. Its shadow bends over the large sphere and goes on "
    "over the disk.",
    {}, &Build });
}

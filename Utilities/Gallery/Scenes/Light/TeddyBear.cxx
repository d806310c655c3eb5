// SPDX-License-Identifier: BSD-3-Clause
// A teddy bear with fur, without and with shadows.

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
  vtkSmartPointer<vtkSpatialObject> all = gallery::Unite(
    { gallery::Place(vtkConstructiveModels::MakeTeddyBear(), { 0.0, 0.1, 0.0 }, 20.0),
      gallery::MakeDisk({ 0.0, 0.0, 0.0 }, 0.74, 0.05, gallery::Plaster()) });
  vtkSmartPointer<vtkImageData> image =
    gallery::Sample(all, vtkBoundingBox(-0.77, 0.77, -0.77, 0.77, -0.1, 1.4), 180, 0.8);
  gallery::ShadowPair pair = gallery::AddShadowPair(
    stage, image, gallery::MakeSolidMatter(image), gallery::MakeStudioLights({ -2.0, -2.0, 3.0 }));
  pair.Look({ 0.1, -1.0, 0.4 }, vtkBoundingBox(-0.73, 0.73, -0.1, 0.1, -0.3, 1.36));
}

const gallery::SceneRegistration registration(
  { "teddy-bear", "2.13", "A teddy bear, without and with shadows",
    "A blend of ellipsoids with fur by noise, in the place of the scanned bear of the source. With "
    "shadows the head lies on the body and the legs on the ground, and the fur has depth.",
    {}, &Build });
}

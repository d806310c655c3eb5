// SPDX-License-Identifier: BSD-3-Clause
// The fuzzy sphere of equation 2.7 over a plate, without and with shadows.

#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Gallery/Stage.h"

#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkSpatialObject.h"
#include "vtkSpatialPrimitive.h"
#include "vtkVolumeProperty.h"

namespace
{
void Build(gallery::Stage& stage)
{
  vtkNew<vtkSpatialPrimitive> fuzzy;
  fuzzy->SetShape(vtkSpatialPrimitive::FUZZY_SPHERE);
  fuzzy->SetRadius(0.5);
  fuzzy->SetInnerRadius(0.2);
  vtkSmartPointer<vtkImageData> image =
    gallery::Sample(gallery::MakeDisk({ 0.0, 0.0, 0.0 }, 0.85, 0.06, gallery::Plaster()),
      vtkBoundingBox(-0.9, 0.9, -0.9, 0.9, -0.1, 1.16), 160);
  gallery::AddSmoke(image, gallery::Place(fuzzy, { 0.0, 0.0, 0.6 }), 0.24, { 0.27, 0.45, 0.68 });
  const double opacity = 0.075;
  gallery::ShadowPair pair =
    gallery::AddShadowPair(stage, image, gallery::MakeSolidMatterInSmoke(image, opacity),
      gallery::MakeStudioLights({ -1.6, -1.2, 3.4 }, 0.9), 3.0 * gallery::SMOKE_GRADIENT);
  pair.Look({ 0.2, -1.0, 0.75 }, vtkBoundingBox(-0.84, 0.84, -0.1, 0.1, -0.35, 1.15));
}

const gallery::SceneRegistration registration(
  { "sphere-shadow", "2.5", "A fuzzy sphere over a plate, without and with shadows",
    "The sphere is dense inside and thins out to its rim. With shadows it is darker on the side "
    "away from the point light, and its shadow on the plate is soft.",
    {}, &Build });
}

// SPDX-License-Identifier: BSD-3-Clause
// A robot under one and under two lights.

#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/LightScreens.h"
#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Gallery/Stage.h"

#include "vtkConstructiveModelSource.h"

namespace
{
void Build(gallery::Stage& stage)
{
  vtkSmartPointer<vtkSpatialObject> all = gallery::Unite({ gallery::MakeFloor({ 0.78, 0.76, 0.74 }),
    gallery::Place(gallery::SoftenEdges(
                     vtkConstructiveModelSource::MakeModel(vtkConstructiveModelSource::ROBOT)),
      { -0.08, 0.0, 0.0 }, -28.0) });
  vtkSmartPointer<vtkImageData> image =
    gallery::Sample(all, vtkBoundingBox(-1.2, 1.1, -1.0, 0.9, -0.06, 1.26), 200);
  vtkSmartPointer<vtkVolumeProperty> medium = gallery::MakeSolidMedium(image);
  gallery::Lights lights = { gallery::MakeFillLight({ 1.0, -1.0, 0.5 }, 0.3),
    gallery::MakePointLight({ -2.6, -1.4, 3.6 }, 1.3) };
  lights.back()->SetDiffuseColor(1.0, 0.82, 0.60);
  gallery::Panel& one = stage.AddPanel("one light");
  one.Add(gallery::MakeSlicedVolume(image, medium));
  one.SetLights(lights);

  lights.push_back(gallery::MakePointLight({ 2.2, -2.4, 3.6 }, 1.3));
  lights.back()->SetDiffuseColor(0.55, 0.74, 1.0);
  gallery::Panel& two = stage.AddPanel("two lights");
  two.Add(gallery::MakeSlicedVolume(image, medium));
  two.SetLights(lights);

  for (gallery::Panel* panel : { &one, &two })
  {
    panel->Frame(vtkBoundingBox(-0.8, 0.66, -0.1, 0.1, -0.42, 1.25));
    gallery::UseBackdrop(*panel, { 0.62, 0.64, 0.70 }, { 0.16, 0.18, 0.24 });
  }
  two.ShareCamera(one);
  one.LookFrom({ 0.1, -1.0, 0.7 }, { 0.0, 0.0, 1.0 });
}

const gallery::SceneRegistration registration(
  { "robot-two-lights", "2.27", "A robot under one and under two lights",
    "A robot of boxes on a floor, a constructive volume. Each light has its own light buffer. In "
    "the shadow of the warm light the blue light still shines, and the other way round. The floor "
    "is darkest where both shadows overlap.",
    {}, &Build });
}

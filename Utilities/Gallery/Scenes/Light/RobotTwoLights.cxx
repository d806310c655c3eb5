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
  vtkSmartPointer<vtkSpatialObject> all =
    gallery::Unite({ gallery::MakeDisk({ 0.0, 0.0, 0.0 }, 1.0, 0.06, gallery::Plaster()),
      gallery::Place(
        gallery::Soften(vtkConstructiveModelSource::MakeModel(vtkConstructiveModelSource::ROBOT)),
        { -0.3, -0.1, 0.0 }, -28.0) });
  vtkSmartPointer<vtkImageData> image =
    gallery::Sample(all, vtkBoundingBox(-1.05, 1.05, -1.05, 1.05, -0.1, 1.28), 190);
  vtkSmartPointer<vtkVolumeProperty> medium = gallery::MakeSolidMedium(image);
  gallery::Lights lights = { gallery::MakeFillLight({ 1.0, -1.0, 0.5 }, 0.2),
    gallery::MakePointLight({ -2.3, -2.0, 4.1 }, 1.0) };
  gallery::Panel& one = stage.AddPanel("one light");
  one.Add(gallery::MakeSlicedVolume(image, medium));
  one.SetLights(lights);

  lights.push_back(gallery::MakePointLight({ -3.0, 0.0, 4.1 }, 1.0));
  gallery::Panel& two = stage.AddPanel("two lights");
  two.Add(gallery::MakeSlicedVolume(image, medium));
  two.SetLights(lights);

  for (gallery::Panel* panel : { &one, &two })
  {
    panel->Frame(vtkBoundingBox(-0.97, 0.97, -0.85, 0.5, -0.1, 1.1));
  }
  two.LookAs(one);
  one.LookFrom({ 0.1, -1.0, 0.7 }, { 0.0, 0.0, 1.0 });
}

const gallery::SceneRegistration registration(
  { "robot-two-lights", "2.27", "A robot under one and under two lights",
    "A robot of boxes on a plate, a constructive volume. Each light has its own light buffer. In "
    "the shadow of one light the other light still shines, and the plate is darkest where both "
    "shadows overlap.",
    {}, &Build });
}

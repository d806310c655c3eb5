// SPDX-License-Identifier: BSD-3-Clause
// A robot under one and under two lights.

#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/LightScreens.h"
#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Gallery/Stage.h"

#include "vtkConstructiveModelSource.h"
#include "vtkSpatialOperation.h"

namespace
{
void Build(gallery::Stage& stage)
{
  vtkSmartPointer<vtkSpatialObject> robot = gallery::SoftenEdges(
    vtkConstructiveModelSource::MakeModel(vtkConstructiveModelSource::ROBOT), 0.014);
  // Narrow gaps below the head and the feet avoid bright rims where surfaces meet.
  vtkSpatialPrimitive::SafeDownCast(vtkSpatialOperation::SafeDownCast(robot)->GetOperand(0))
    ->SetCenter(0.0, 0.0, 1.108);
  vtkSmartPointer<vtkSpatialObject> all = gallery::Unite({ gallery::MakeFloor({ 0.78, 0.76, 0.74 }),
    gallery::Place(robot, { -0.4, -0.05, 0.018 }, -46.0) });
  vtkSmartPointer<vtkImageData> image =
    gallery::Sample(all, vtkBoundingBox(-1.3, 1.3, -1.25, 1.2, -0.04, 1.3), 290, 0.9);
  vtkSmartPointer<vtkVolumeProperty> medium = gallery::MakeSolidMedium(image);
  gallery::Lights lights = { gallery::MakeFillLight({ 1.0, -1.0, 0.5 }, 0.35),
    gallery::MakePointLight({ -2.9, -2.2, 4.6 }, 1.4) };
  lights.back()->SetDiffuseColor(1.0, 0.82, 0.60);
  gallery::Panel& one = stage.AddPanel("one light");
  one.Add(gallery::MakeSlicedVolume(image, medium));
  one.SetLights(lights);

  lights.push_back(gallery::MakePointLight({ -3.6, 0.8, 5.2 }, 1.3));
  lights.back()->SetDiffuseColor(0.55, 0.74, 1.0);
  gallery::Panel& two = stage.AddPanel("two lights");
  two.Add(gallery::MakeSlicedVolume(image, medium));
  two.SetLights(lights);

  for (gallery::Panel* panel : { &one, &two })
  {
    panel->Frame(vtkBoundingBox(-0.82, 0.92, -0.1, 0.1, -0.25, 1.2));
    panel->SetBackground({ 0.62, 0.64, 0.70 }, { 0.16, 0.18, 0.24 });
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

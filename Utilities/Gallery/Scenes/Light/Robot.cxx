// SPDX-License-Identifier: BSD-3-Clause
// A robot of boxes and its shadow.

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
vtkSmartPointer<vtkImageData> SampleRobot()
{
  vtkSmartPointer<vtkSpatialObject> all =
    gallery::Unite({ gallery::Place(gallery::Soften(vtkConstructiveModels::MakeRobot()),
                       { -0.25, 0.0, 0.0 }, -28.0),
      gallery::MakeDisk({ 0.0, 0.0, 0.0 }, 1.0, 0.06, gallery::Plaster()) });
  return gallery::Sample(all, vtkBoundingBox(-1.05, 1.05, -1.05, 1.05, -0.1, 1.28), 230, 0.9);
}

void Build(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = SampleRobot();
  gallery::Panel& panel = gallery::AddShadowPanel(
    stage, image, gallery::MakeSolidMatter(image), gallery::MakeStudioLights({ -2.6, -2.2, 3.6 }));
  panel.LookFrom({ 0.15, -1.0, 0.55 }, { 0.0, 0.0, 1.0 });
  panel.Frame(vtkBoundingBox(-1.0, 1.0, -0.1, 0.1, -0.66, 1.3));
}

void BuildSoft(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = SampleRobot();
  gallery::AddSoftPair(stage, image, gallery::MakeSolidMatter(image),
    gallery::MakeStudioLights({ -2.6, -2.2, 3.6 }), 0.8, 0.0, 640)
    .Look({ 0.15, -1.0, 0.6 }, vtkBoundingBox(-0.95, 0.95, -0.1, 0.1, -0.6, 1.25));
}

const gallery::SceneRegistration registration({ "robot", "2.6", "The shadow of a robot",
  "A robot of two cubes and two boxes, a union of constructive volume geometry, stands on a disk. "
  "The point light is at the upper left; the legs, the body and the head cast a shadow with sharp "
  "edges on the disk.",
  {}, &Build });

const gallery::SceneRegistration softRegistration({ "robot-soft", "2.34",
  "The hard and the soft shadow of a robot",
  "The same robot in the light of a point and of a disk. The shadow of the feet stays sharp, that "
  "of the head is far from what throws it, and its edge is wide.",
  {}, &BuildSoft });
}

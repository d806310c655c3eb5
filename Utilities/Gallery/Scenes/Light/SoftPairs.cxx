// SPDX-License-Identifier: BSD-3-Clause
// Objects on a plate: with hard shadows, and as pairs of panels with hard and soft shadows.

#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/SoftShadows.h"
#include "Gallery/Stage.h"

#include "vtkConstructiveModelSource.h"

namespace
{
vtkSmartPointer<vtkImageData> SampleSphere()
{
  vtkSmartPointer<vtkSpatialObject> all = gallery::Unite(
    { gallery::Place(
        vtkConstructiveModelSource::MakeModel(vtkConstructiveModelSource::HYPERTEXTURE_SPHERE),
        { 0.0, 0.0, 0.62 }),
      gallery::MakeDisk({ 0.0, 0.0, 0.0 }, 1.0, 0.05, gallery::Plaster()) });
  return gallery::Sample(all, vtkBoundingBox(-1.05, 1.05, -1.05, 1.05, -0.1, 1.35), 170, 0.7);
}

void BuildHypertexture(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = SampleSphere();
  gallery::Panel& panel = gallery::AddShadowPanel(
    stage, image, gallery::MakeSolidMedium(image), gallery::MakeStudioLights({ -2.4, -1.4, 3.0 }));
  panel.LookFrom({ 0.15, -1.0, 0.5 }, { 0.0, 0.0, 1.0 });
  panel.Frame(vtkBoundingBox(-1.0, 1.0, -0.1, 0.1, -0.62, 1.35));
}

void BuildHypertextureSoft(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = SampleSphere();
  gallery::AddSoftPair(stage, image, gallery::MakeSolidMedium(image),
    gallery::MakeStudioLights({ -2.4, -1.4, 3.0 }), 1.0)
    .Look({ 0.15, -1.0, 0.55 }, vtkBoundingBox(-0.98, 0.98, -0.1, 0.1, -0.58, 1.32));
}

const gallery::SceneRegistration hypertexture(
  { "hypertexture", "2.12", "A hypertextured sphere with its shadow",
    "A sphere whose surface is displaced by a sum of octaves of noise. Its bumps shade its "
    "hollows, and the shadow on the disk shows its rough outline.",
    {}, &BuildHypertexture });

const gallery::SceneRegistration hypertextureSoft({ "hypertexture-soft", "2.37",
  "A hypertextured sphere under a point light and under a disk light",
  "Light of the disk reaches around the bumps, and the rough outline of the shadow on the plate "
  "becomes softer with the distance from the sphere.",
  {}, &BuildHypertextureSoft });

vtkSmartPointer<vtkImageData> SampleRobot()
{
  vtkSmartPointer<vtkSpatialObject> all = gallery::Unite(
    { gallery::Place(
        gallery::Soften(vtkConstructiveModelSource::MakeModel(vtkConstructiveModelSource::ROBOT)),
        { -0.25, 0.0, 0.0 }, -28.0),
      gallery::MakeDisk({ 0.0, 0.0, 0.0 }, 1.0, 0.06, gallery::Plaster()) });
  return gallery::Sample(all, vtkBoundingBox(-1.05, 1.05, -1.05, 1.05, -0.1, 1.28), 230, 0.9);
}

void BuildRobot(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = SampleRobot();
  gallery::Panel& panel = gallery::AddShadowPanel(
    stage, image, gallery::MakeSolidMedium(image), gallery::MakeStudioLights({ -2.6, -2.2, 3.6 }));
  panel.LookFrom({ 0.15, -1.0, 0.55 }, { 0.0, 0.0, 1.0 });
  panel.Frame(vtkBoundingBox(-1.0, 1.0, -0.1, 0.1, -0.66, 1.3));
}

void BuildRobotSoft(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = SampleRobot();
  gallery::AddSoftPair(stage, image, gallery::MakeSolidMedium(image),
    gallery::MakeStudioLights({ -2.6, -2.2, 3.6 }), 0.8, 0.0, 640)
    .Look({ 0.15, -1.0, 0.6 }, vtkBoundingBox(-0.95, 0.95, -0.1, 0.1, -0.6, 1.25));
}

const gallery::SceneRegistration robot({ "robot", "2.6", "The shadow of a robot",
  "A robot of two cubes and two boxes, a constructive volume, stands on a disk. The point light is "
  "at the upper left. The legs, the body and the head cast a shadow with sharp edges on the disk.",
  {}, &BuildRobot });

const gallery::SceneRegistration robotSoft(
  { "robot-soft", "2.34", "The hard and the soft shadow of a robot",
    "The same robot under a point light and under a disk light. The shadow of the feet is sharp. "
    "The shadow of the head, far from the head, has a wide edge.",
    {}, &BuildRobotSoft });
}

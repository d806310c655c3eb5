// SPDX-License-Identifier: BSD-3-Clause
// Objects on a floor: with hard shadows, and as pairs of panels with hard and soft shadows.

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
      gallery::MakeFloor({ 0.50, 0.55, 0.60 }) });
  return gallery::Sample(all, vtkBoundingBox(-1.75, 1.75, -1.15, 1.1, -0.06, 1.3), 270, 0.7);
}

void BuildHypertexture(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = SampleSphere();
  gallery::Panel& panel = gallery::AddShadowPanel(
    stage, image, gallery::MakeSolidMedium(image), gallery::MakeStudioLights({ -2.4, -1.4, 2.6 }));
  gallery::UseBackdrop(panel, { 0.78, 0.82, 0.86 }, { 0.16, 0.20, 0.28 });
  panel.LookFrom({ 0.15, -1.0, 0.5 }, { 0.0, 0.0, 1.0 });
  panel.Frame(vtkBoundingBox(-1.0, 1.15, -0.1, 0.1, -0.26, 1.29));
}

void BuildHypertextureSoft(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = SampleSphere();
  gallery::SoftShadowPair pair = gallery::AddSoftShadowPair(stage, image,
    gallery::MakeSolidMedium(image), gallery::MakeStudioLights({ -1.1, -1.3, 4.6 }), 1.1, 0.0, 640);
  pair.UseBackdrop({ 0.86, 0.80, 0.74 }, { 0.36, 0.26, 0.28 });
  pair.Look({ 0.15, -1.0, 0.55 }, vtkBoundingBox(-0.66, 0.98, -0.1, 0.1, -0.3, 1.3));
}

const gallery::SceneRegistration hypertexture(
  { "hypertexture", "2.12", "A hypertextured sphere with its shadow",
    "A sphere whose surface is displaced by a sum of octaves of noise. Its bumps shade its "
    "hollows, and the shadow on the floor shows its rough outline.",
    {}, &BuildHypertexture });

const gallery::SceneRegistration hypertextureSoft({ "hypertexture-soft", "2.37",
  "A hypertextured sphere under a point light and under a disk light",
  "Light of the disk reaches around the bumps, and the rough outline of the shadow on the floor "
  "becomes softer with the distance from the sphere.",
  {}, &BuildHypertextureSoft });

vtkSmartPointer<vtkImageData> SampleRobot()
{
  vtkSmartPointer<vtkSpatialObject> all = gallery::Unite(
    { gallery::Place(gallery::SoftenEdges(
                       vtkConstructiveModelSource::MakeModel(vtkConstructiveModelSource::ROBOT)),
        { -0.25, 0.0, 0.0 }, -28.0),
      gallery::MakeFloor({ 0.84, 0.78, 0.68 }) });
  return gallery::Sample(all, vtkBoundingBox(-1.6, 1.55, -1.15, 1.05, -0.06, 1.26), 300, 0.9);
}

void BuildRobot(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = SampleRobot();
  gallery::Panel& panel = gallery::AddShadowPanel(
    stage, image, gallery::MakeSolidMedium(image), gallery::MakeStudioLights({ -2.6, -2.2, 3.2 }));
  gallery::UseBackdrop(panel, { 0.90, 0.86, 0.80 }, { 0.40, 0.52, 0.60 });
  panel.LookFrom({ 0.15, -1.0, 0.55 }, { 0.0, 0.0, 1.0 });
  panel.Frame(vtkBoundingBox(-0.95, 1.15, -0.1, 0.1, -0.28, 1.27));
}

void BuildRobotSoft(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = SampleRobot();
  gallery::SoftShadowPair pair =
    gallery::AddSoftShadowPair(stage, image, gallery::MakeSolidMedium(image),
      gallery::MakeStudioLights({ -1.6, -2.0, 4.6 }, 0.85), 0.7, 0.0, 640);
  pair.UseBackdrop({ 0.86, 0.88, 0.90 }, { 0.34, 0.38, 0.52 });
  pair.Look({ 0.15, -1.0, 0.6 }, vtkBoundingBox(-0.72, 0.78, -0.1, 0.1, -0.4, 1.25));
}

const gallery::SceneRegistration robot({ "robot", "2.6", "The shadow of a robot",
  "A robot of two cubes and two boxes, a constructive volume, stands on a floor. The point light "
  "is "
  "at the upper left. The legs, the body and the head cast a shadow with sharp edges on the floor.",
  {}, &BuildRobot });

const gallery::SceneRegistration robotSoft(
  { "robot-soft", "2.34", "The hard and the soft shadow of a robot",
    "The same robot under a point light and under a disk light. The shadow of the feet is sharp. "
    "The shadow of the head, far from the head, has a wide edge.",
    {}, &BuildRobotSoft });
}

// SPDX-License-Identifier: BSD-3-Clause
// Objects on a floor: with hard shadows, and as pairs of panels with hard and soft shadows.

#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/SoftShadows.h"
#include "Gallery/Stage.h"

#include "vtkConstructiveModelSource.h"
#include "vtkSpatialOperation.h"
#include "vtkSpatialTurbulence.h"

namespace
{
vtkSmartPointer<vtkImageData> SampleSphere()
{
  vtkSmartPointer<vtkSpatialObject> sphere =
    vtkConstructiveModelSource::MakeModel(vtkConstructiveModelSource::HYPERTEXTURE_SPHERE);
  // With less noise than in the model, no parts come off the sphere.
  vtkSpatialTurbulence::SafeDownCast(vtkSpatialOperation::SafeDownCast(sphere)->GetOperand(0))
    ->SetAmplitude(0.12);
  // With a narrower edge, a weave would be visible on the floor.
  vtkSmartPointer<vtkSpatialObject> all =
    gallery::Unite({ gallery::Place(sphere, { 0.0, 0.0, 0.62 }),
      gallery::SoftenEdges(gallery::MakeFloor({ 0.80, 0.79, 0.77 }), 0.03) });
  return gallery::Sample(all, vtkBoundingBox(-1.68, 1.76, -1.3, 1.2, -0.04, 1.3), 330, 0.7);
}

void BuildHypertexture(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = SampleSphere();
  const gallery::Lights lights = gallery::MakeStudioLights({ -2.6, -1.5, 3.8 });
  lights.back()->SetIntensity(0.4);
  gallery::Panel& panel =
    gallery::AddShadowPanel(stage, image, gallery::MakeSolidMedium(image), lights);
  panel.SetBackground({ 0.78, 0.82, 0.86 }, { 0.16, 0.20, 0.28 });
  panel.LookFrom({ 0.15, -1.0, 0.5 }, { 0.0, 0.0, 1.0 });
  panel.Frame(vtkBoundingBox(-0.85, 1.35, -0.1, 0.1, -0.12, 1.24));
}

void BuildHypertextureSoft(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = SampleSphere();
  gallery::SoftShadowPair pair =
    gallery::AddSoftShadowPair(stage, image, gallery::MakeSolidMedium(image),
      gallery::MakeStudioLights({ -1.3, -1.3, 4.6 }, 0.9), 1.1, 0.0, 768);
  pair.SetBackground({ 0.86, 0.80, 0.74 }, { 0.36, 0.26, 0.28 });
  pair.Look({ 0.15, -1.0, 0.55 }, vtkBoundingBox(-0.63, 0.98, -0.1, 0.1, -0.22, 1.25));
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
  vtkSmartPointer<vtkSpatialObject> robot = gallery::SoftenEdges(
    vtkConstructiveModelSource::MakeModel(vtkConstructiveModelSource::ROBOT), 0.014);
  // Narrow gaps below the head and the feet avoid bright rims where surfaces meet.
  vtkSpatialPrimitive::SafeDownCast(vtkSpatialOperation::SafeDownCast(robot)->GetOperand(0))
    ->SetCenter(0.0, 0.0, 1.108);
  vtkSmartPointer<vtkSpatialObject> all =
    gallery::Unite({ gallery::Place(robot, { -0.4, -0.1, 0.018 }, -46.0),
      gallery::MakeFloor({ 0.84, 0.78, 0.68 }) });
  return gallery::Sample(all, vtkBoundingBox(-1.92, 1.65, -1.15, 1.2, -0.04, 1.3), 390, 0.9);
}

void BuildRobot(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = SampleRobot();
  gallery::Panel& panel = gallery::AddShadowPanel(
    stage, image, gallery::MakeSolidMedium(image), gallery::MakeStudioLights({ -3.2, -2.05, 4.2 }));
  panel.SetBackground({ 0.90, 0.86, 0.80 }, { 0.40, 0.52, 0.60 });
  panel.LookFrom({ 0.15, -1.0, 0.55 }, { 0.0, 0.0, 1.0 });
  panel.Frame(vtkBoundingBox(-0.95, 1.15, -0.1, 0.1, -0.28, 1.27));
}

void BuildRobotSoft(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = SampleRobot();
  gallery::SoftShadowPair pair = gallery::AddSoftShadowPair(stage, image,
    gallery::MakeSolidMedium(image), gallery::MakeStudioLights({ -2.6, -2.3, 4.8 }), 0.7, 0.0, 768);
  pair.SetBackground({ 0.86, 0.88, 0.90 }, { 0.34, 0.38, 0.52 });
  pair.Look({ 0.2, -1.0, 0.7 }, vtkBoundingBox(-0.8, 0.7, -0.1, 0.1, -0.2, 1.2));
}

const gallery::SceneRegistration robot({ "robot", "2.6", "The shadow of a robot",
  "A robot of two cubes and two boxes, a constructive volume, stands on a floor. The point light "
  "is at the upper left. The shadow on the floor has sharp edges and the outlines of a leg, the "
  "body and the head.",
  {}, &BuildRobot });

const gallery::SceneRegistration robotSoft(
  { "robot-soft", "2.34", "The hard and the soft shadow of a robot",
    "The same robot under a point light and under a disk light. The shadow of the feet is sharp. "
    "The shadow of the head, far from the head, has a wide edge.",
    {}, &BuildRobotSoft });
}

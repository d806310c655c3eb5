// SPDX-License-Identifier: BSD-3-Clause
// The shadow of a ring within a translucent box, hard and soft.

#include "Gallery/Look.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/LightScreens.h"
#include "Gallery/Scenes/Light/SoftShadows.h"
#include "Gallery/Stage.h"

namespace
{
vtkSmartPointer<vtkSpatialPrimitive> MakeRing(const vtkVector3d& center)
{
  auto ring = vtkSmartPointer<vtkSpatialPrimitive>::New();
  ring->SetShapeToTorus();
  ring->SetCenter(center[0], center[1], center[2]);
  ring->SetRadius(0.3);
  ring->SetTubeRadius(0.075);
  ring->SetColor(0.10, 0.26, 0.72);
  ring->SetEdgeWidth(gallery::EDGE_WIDTH);
  return ring;
}

void Build(gallery::Stage& stage)
{
  const vtkColor3d ice(0.80, 0.93, 0.97);
  const vtkColor3d slate(0.36, 0.35, 0.34);
  vtkSmartPointer<vtkImageData> image = gallery::Sample(
    gallery::Unite(
      { MakeRing({ 0.0, 0.0, 1.36 }), gallery::MakeDisk({ 0.0, 0.0, 0.0 }, 1.05, 0.06, slate) }),
    vtkBoundingBox(-1.1, 1.1, -1.1, 1.1, -0.1, 1.5), 115);
  gallery::AddSmoke(
    image, gallery::MakeBox({ -0.52, -0.4, 0.04 }, { 0.52, 0.4, 1.12 }, ice), 0.2, ice);
  vtkSmartPointer<vtkVolumeProperty> medium = gallery::MakeSolidMediumInSmoke(image, 0.022);
  medium->SetAmbient(0.05);
  const gallery::Lights lights = { gallery::MakePointLight({ -0.4, -0.15, 3.3 }, 2.8),
    gallery::MakeFillLight({ 0.6, -1.0, 0.5 }, 0.12) };
  gallery::SoftPair pair =
    gallery::AddSoftPair(stage, image, medium, lights, 0.45, gallery::SMOKE_GRADIENT, 192);
  for (gallery::Panel* panel : { &pair.Hard, &pair.Soft })
  {
    panel->SetBackground(gallery::DarkBackground());
  }
  pair.Look({ 0.3, -1.0, 0.36 }, vtkBoundingBox(-0.95, 0.95, -0.1, 0.1, -0.36, 1.42));
}

const gallery::SceneRegistration registration(
  { "box-soft", "2.35", "The shadow of a ring within a translucent box, hard and soft",
    "A ring floats above a translucent box, and its shadow extends down through the box to the "
    "plate. Under a disk light the shadow is as sharp as under a point light where it enters the "
    "box. Farther down, its edges widen until they merge.",
    {}, &Build });
}

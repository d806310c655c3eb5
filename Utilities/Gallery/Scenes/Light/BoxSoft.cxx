// SPDX-License-Identifier: BSD-3-Clause
// The shadow of a ring within a translucent box, hard and soft.

#include "Gallery/Look.h"
#include "Gallery/Panel.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/LightScreens.h"
#include "Gallery/Scenes/Light/SoftShadows.h"
#include "Gallery/Stage.h"

#include "vtkActor.h"
#include "vtkCubeSource.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

namespace
{
vtkSmartPointer<vtkSpatialPrimitive> MakeRing(const vtkVector3d& center)
{
  auto ring = vtkSmartPointer<vtkSpatialPrimitive>::New();
  ring->SetShapeToTorus();
  ring->SetCenter(center[0], center[1], center[2]);
  ring->SetRadius(0.22);
  ring->SetTubeRadius(0.06);
  ring->SetColor(0.95, 0.50, 0.14);
  ring->SetEdgeWidth(gallery::EDGE_WIDTH);
  return ring;
}

vtkSmartPointer<vtkActor> MakeOutline(const double bounds[6])
{
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(bounds);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(cube->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  const vtkColor3d color = gallery::OutlineColor();
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetRepresentationToWireframe();
  actor->GetProperty()->SetLineWidth(2.0);
  actor->GetProperty()->LightingOff();
  return actor;
}

void Build(gallery::Stage& stage)
{
  const vtkColor3d ice(0.80, 0.93, 0.97);
  const vtkColor3d slate(0.36, 0.36, 0.38);
  vtkSmartPointer<vtkImageData> image =
    gallery::Sample(gallery::Unite({ MakeRing({ 0.0, 0.0, 1.23 }), gallery::MakeFloor(slate) }),
      vtkBoundingBox(-1.5, 1.3, -1.5, 0.95, -0.06, 1.36), 155);
  vtkSmartPointer<vtkSpatialPrimitive> box =
    gallery::MakeBox({ -0.64, -0.5, 0.0 }, { 0.64, 0.5, 1.12 }, ice);
  const double bounds[6] = { -0.64, 0.64, -0.5, 0.5, 0.02, 1.12 };
  // With this edge width, the density changes by less than the surface gradient passed to
  // AddSoftShadowPair(), so the box is not shaded as a surface.
  box->SetEdgeWidth(0.04);
  gallery::AddSmoke(image, box, 0.2, ice);
  vtkSmartPointer<vtkVolumeProperty> medium = gallery::MakeSolidMediumInSmoke(image, 0.013);
  medium->SetAmbient(0.05);
  const gallery::Lights lights = { gallery::MakePointLight({ -0.25, -0.1, 3.3 }, 2.3),
    gallery::MakeFillLight({ 0.6, -1.0, 0.5 }, 0.12) };
  gallery::SoftShadowPair pair = gallery::AddSoftShadowPair(
    stage, image, medium, lights, 0.45, 10.0 * gallery::SMOKE_GRADIENT, 512);
  pair.SetBackground({ 0.20, 0.23, 0.27 }, { 0.05, 0.06, 0.08 });
  for (gallery::Panel* panel : { &pair.Hard, &pair.Soft })
  {
    panel->Add(MakeOutline(bounds));
    panel->SetAmbientOcclusion(0.0);
  }
  pair.Look({ 0.2, -1.0, 0.36 }, vtkBoundingBox(-0.82, 0.82, -0.1, 0.1, -0.25, 1.36));
}

const gallery::SceneRegistration registration(
  { "box-soft", "2.35", "The shadow of a ring within a translucent box, hard and soft",
    "A ring floats above a translucent box, and its shadow extends down through the box to the "
    "floor. Under a disk light the shadow is as sharp as under a point light where it enters the "
    "box. Farther down, its edges widen until they merge.",
    {}, &Build });
}

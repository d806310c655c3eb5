// SPDX-License-Identifier: BSD-3-Clause
// A room with the sun in its window.

#include "Gallery/Panel.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/HazyRoom.h"
#include "Gallery/Scenes/Light/LightScreens.h"

#include "vtkActor.h"
#include "vtkConstructiveModelSource.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSpatialOperation.h"

namespace
{
/// Returns a room that is open only toward the camera. The wall at +y has a window on the left.
vtkSmartPointer<vtkSpatialObject> MakeShell()
{
  const vtkColor3d plaster = gallery::PlasterColor();
  const vtkColor3d wood(0.60, 0.42, 0.27);
  auto wall = vtkSmartPointer<vtkSpatialOperation>::New();
  wall->SetOperationToDifference();
  wall->AddOperand(gallery::MakeBox({ -1.26, 1.0, -0.06 }, { 1.26, 1.06, 1.56 }, plaster));
  wall->AddOperand(gallery::MakeBox({ -0.75, 0.9, 0.5 }, { 0.25, 1.15, 1.3 }, plaster));
  return gallery::Unite({ gallery::MakeBox({ -1.26, -1.0, -0.06 }, { 1.26, 1.06, 0.0 }, wood),
    gallery::MakeBox({ -1.26, -1.0, -0.06 }, { -1.2, 1.06, 1.56 }, plaster),
    gallery::MakeBox({ 1.2, -1.0, -0.06 }, { 1.26, 1.06, 1.56 }, plaster),
    gallery::MakeBox({ -1.26, -1.0, 1.5 }, { 1.26, 1.06, 1.56 }, plaster), wall,
    gallery::MakeBox({ -0.75, 1.0, 0.88 }, { 0.25, 1.06, 0.92 }, wood),
    gallery::MakeBox({ -0.27, 1.0, 0.5 }, { -0.23, 1.06, 1.3 }, wood) });
}

/// Returns the sky behind the window.
vtkSmartPointer<vtkActor> MakeSky()
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-0.9, 1.1, 0.4);
  plane->SetPoint1(0.4, 1.1, 0.4);
  plane->SetPoint2(-0.9, 1.1, 1.4);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(0.93, 0.95, 1.0);
  return actor;
}

void Build(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = gallery::Sample(
    gallery::Unite({ MakeShell(),
      gallery::Place(gallery::SoftenEdges(
                       vtkConstructiveModelSource::MakeModel(vtkConstructiveModelSource::DESK)),
        { 0.5, 0.3, 0.0 }, 6.0),
      gallery::Place(gallery::SoftenEdges(
                       vtkConstructiveModelSource::MakeModel(vtkConstructiveModelSource::CHAIR)),
        { -0.15, 0.1, 0.0 }, 118.0) }),
    vtkBoundingBox(-1.3, 1.3, -1.04, 1.1, -0.1, 1.6), 220);
  vtkSmartPointer<vtkLight> sun = gallery::MakeParallelLight({ -0.5, 1.0, 0.56 }, 6.2);
  sun->SetDiffuseColor(1.0, 0.87, 0.68);

  gallery::Panel& panel =
    gallery::AddHazyPanel(stage, image, vtkBoundingBox(-1.2, 1.2, -1.0, 1.0, 0.0, 1.5), 0.0036,
      { sun, gallery::MakeFillLight({ 0.3, -1.0, 0.6 }, 0.28) });
  panel.SetAmbientOcclusion(0.0);
  panel.Add(MakeSky());
  panel.Frame(vtkBoundingBox(-1.06, 1.06, -1.0, -0.99, 0.12, 1.41));
  panel.LookFrom({ 0.12, -1.0, 0.08 }, { 0.0, 0.0, 1.0 });
}

const gallery::SceneRegistration registration(
  { "room-backlit", "2.16", "A hazy room with the sun in its window",
    "The sun shines through a window into a room with a desk and a chair, one constructive volume. "
    "Its light is visible in the haze, and so are the shadows of the window bars and of the "
    "furniture. Since the light is behind the volume, slices are drawn from back to front.",
    {}, &Build });
}

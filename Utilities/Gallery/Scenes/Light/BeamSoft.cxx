// SPDX-License-Identifier: BSD-3-Clause
// Beams of light behind the holes of a screen, hard and soft.

#include "Gallery/Look.h"
#include "Gallery/Panel.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Gallery/Scenes/Light/SoftShadows.h"
#include "Gallery/Scenes/Light/TranslucentBox.h"
#include "Gallery/Stage.h"
#include "Gallery/VectorArithmetic.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkSpatialObject.h"
#include "vtkSpatialOperation.h"
#include "vtkSpatialPrimitive.h"
#include "vtkTransform.h"
#include "vtkVolumeProperty.h"

namespace
{
const vtkVector3d BOX(0.6, 0.6, 0.84);
const vtkVector3d PLACE(0.42, 0.0, 0.0);
constexpr double DEGREES = 24.0;

/// A screen across the x axis, with three holes above each other.
vtkSmartPointer<vtkSpatialObject> MakeScreen()
{
  const vtkColor3d metal(0.42, 0.45, 0.50);
  auto screen = vtkSmartPointer<vtkSpatialOperation>::New();
  screen->SetOperationToDifference();
  screen->AddOperand(gallery::MakeDisk({ 0.0, 0.0, 0.03 }, 0.66, 0.06, metal));
  for (const double aside : { -0.2, 0.0, 0.2 })
  {
    screen->AddOperand(gallery::MakeDisk({ aside, 0.0, 0.2 }, 0.065, 0.4, metal));
  }
  vtkNew<vtkTransform> transform;
  transform->Translate(-0.95, 0.0, 0.0);
  transform->RotateY(90.0);
  screen->SetTransform(transform);
  return screen;
}

void Build(gallery::Stage& stage)
{
  const vtkColor3d white(1.0, 1.0, 1.0);
  vtkSmartPointer<vtkImageData> image =
    gallery::Sample(MakeScreen(), vtkBoundingBox(-1.05, 1.25, -0.7, 0.7, -0.7, 0.7), 115);
  vtkSmartPointer<vtkSpatialPrimitive> air =
    gallery::MakeBox({ -0.9, -0.5, -0.5 }, { 1.2, 0.5, 0.5 }, white);
  air->SetDensity(0.16);
  air->SetEdgeWidth(0.2);
  gallery::AddSmoke(image,
    gallery::Unite(
      { gallery::Place(gallery::MakeBox(-0.5 * BOX, 0.5 * BOX, white), PLACE, DEGREES), air }),
    0.2, white);
  vtkSmartPointer<vtkVolumeProperty> matter = gallery::MakeSolidMatterInSmoke(image, 0.03);
  matter->SetAmbient(0.03);
  vtkSmartPointer<vtkLight> lamp = gallery::MakePointLight({ -3.2, 0.0, 0.0 }, 15.0);
  lamp->SetDiffuseColor(1.0, 0.86, 0.6);
  // All of this scatters evenly, at its edges too.
  gallery::SoftPair pair = gallery::AddSoftPair(stage, image, matter, { lamp }, 0.4, 1.0, 192);
  for (gallery::Panel* panel : { &pair.Hard, &pair.Soft })
  {
    panel->SetBackground(gallery::DarkBackground());
    panel->SetAmbientOcclusion(0.0);
    vtkSmartPointer<vtkActor> frame = gallery::MakeBoxFrame(BOX, DEGREES);
    frame->SetPosition(PLACE[0], PLACE[1], PLACE[2]);
    panel->Add(frame);
  }
  pair.Look({ 0.35, -1.0, 0.25 }, vtkBoundingBox(-0.98, 0.92, -0.1, 0.1, -0.5, 0.5));
}

const gallery::SceneRegistration registration(
  { "beam-soft", "2.38", "Beams of light behind holes, hard and soft",
    "Light falls through three holes of a screen into thin smoke and a translucent box. In the "
    "light of a point each beam keeps its edge; in that of a disk the beams widen behind the holes "
    "and flow into each other, and their cores fade.",
    {}, &Build });
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Scenes/Light/Room.h"

#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Gallery/VectorArithmetic.h"

#include "vtkConstructiveModelSource.h"
#include "vtkNew.h"
#include "vtkSpatialTurbulence.h"
#include "vtkTransform.h"

namespace gallery
{
namespace
{
/// Returns upright rings that lean on the wall at +y.
vtkSmartPointer<vtkSpatialObject> MakeLeaningRings()
{
  vtkSmartPointer<vtkSpatialObject> rings = Unite({ SoftenEdges(
    vtkConstructiveModelSource::MakeModel(vtkConstructiveModelSource::RINGS), 0.02) });
  vtkNew<vtkTransform> transform;
  transform->Translate(0.45, 0.66, 0.47);
  transform->RotateX(74.0);
  transform->RotateZ(30.0);
  transform->Scale(0.5, 0.5, 0.5);
  rings->SetTransform(transform);
  return rings;
}

vtkSmartPointer<vtkSpatialObject> MakeSmallRobot()
{
  vtkSmartPointer<vtkSpatialObject> robot = Unite({ SoftenEdges(
    vtkConstructiveModelSource::MakeModel(vtkConstructiveModelSource::ROBOT), 0.02) });
  vtkNew<vtkTransform> transform;
  // A narrow gap below the feet avoids bright rims. Faces at an angle to the sampling grid would
  // have streaks.
  transform->Translate(-0.4, 0.1, 0.018);
  transform->Scale(0.75, 0.75, 0.75);
  robot->SetTransform(transform);
  return robot;
}
}

vtkSmartPointer<vtkSpatialObject> MakeRoom(const vtkBoundingBox& inside)
{
  const double thickness = 0.05;
  vtkVector3d lower;
  vtkVector3d upper;
  inside.GetMinPoint(lower.GetData());
  inside.GetMaxPoint(upper.GetData());
  const vtkVector3d outside = lower - vtkVector3d(thickness, 0.0, thickness);
  const double back = upper[1] + thickness;
  // Gaps between the floor and the walls avoid bright rims.
  const double gap = 0.022;
  const double behind = upper[1] - gap;
  return Unite({ MakeBox({ lower[0] + gap, lower[1], outside[2] }, { upper[0], behind, lower[2] },
                   { 0.70, 0.58, 0.46 }),
    MakeBox(outside, { lower[0], behind, upper[2] }, PlasterColor()),
    MakeBox({ outside[0], upper[1], outside[2] }, { upper[0], back, upper[2] }, PlasterColor()) });
}

vtkSmartPointer<vtkSpatialObject> MakePuff(const vtkVector3d& center)
{
  vtkNew<vtkSpatialPrimitive> sphere;
  sphere->SetShape(vtkSpatialPrimitive::FUZZY_SPHERE);
  sphere->SetRadius(0.32);
  sphere->SetInnerRadius(0.05);
  vtkNew<vtkSpatialTurbulence> puff;
  puff->SetOperand(sphere);
  puff->SetFrequency(5.0);
  puff->SetAmplitude(0.1);
  puff->SetSum(vtkTurbulenceSource::FRACTAL_SUM);
  return Place(puff, center);
}

vtkSmartPointer<vtkImageData> SampleFurnishedRoom(int resolution)
{
  vtkSmartPointer<vtkSpatialObject> all =
    Unite({ MakeSmallRobot(), MakeLeaningRings(), MakeRoom() });
  vtkSmartPointer<vtkImageData> image =
    Sample(all, vtkBoundingBox(-1.1, 1.05, -1.05, 1.1, -0.1, 1.35), resolution);
  AddSmoke(image, MakePuff({ 0.75, -0.75, 0.45 }), 0.24, { 0.80, 0.82, 0.85 });
  return image;
}
}

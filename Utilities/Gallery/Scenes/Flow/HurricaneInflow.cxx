// SPDX-License-Identifier: BSD-3-Clause
// A textured tube around the eye of a hurricane, above a map.

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Flow/FlowScene.h"
#include "Gallery/Scenes/Flow/InflowPaint.h"
#include "Gallery/Stage.h"
#include "Support/Inputs/DataFiles.h"

#include "vtkFlowStatus.h"
#include "vtkImplicitFlowVolumeMapper.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlaneSource.h"
#include "vtkProperty.h"
#include "vtkTerminationTube.h"
#include "vtkTexture.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkTriangleFilter.h"
#include "vtkVolumeProperty.h"
#include "vtkVortexAxis.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double EYE = 0.21;
constexpr double TIME = 3.4;

/// z of the sea, and scales of the map in degrees per unit of length.
constexpr double SEA = -0.5;
constexpr double DEGREES_EAST = 8.75;
constexpr double DEGREES_NORTH = 7.35;

/// Longitude and latitude of the point at x = y = 0, in degrees.
constexpr double CENTER[2] = { -70.75, 30.5 };

/// Bounds of the map, in degrees.
constexpr double WEST = -91.5;
constexpr double EAST = -53.5;
constexpr double SOUTH = 16.7;
constexpr double NORTH = 48.7;

/// Returns the color and opacity of eight spokes in four colors, which fade to less opaque white
/// between them.
gallery::Paint Spokes(double u, double)
{
  const double spoke = 8.0 * u - std::floor(8.0 * u) - 0.5;
  const double strength = std::pow(std::cos(vtkMath::Pi() * spoke), 2.0);
  const vtkColor3d color = gallery::IntervalColor(static_cast<int>(8.0 * u) % 4);
  gallery::Paint paint;
  for (int c = 0; c < 3; ++c)
  {
    paint.Color[c] = strength * color[c] + (1.0 - strength);
  }
  paint.Opacity = 0.35 + 0.65 * strength;
  return paint;
}

/// As above, but only on the upper half of the tube, where air leaves the tube.
gallery::Paint UpperSpokes(double u, double v)
{
  gallery::Paint paint = Spokes(u, v);
  paint.Opacity *= std::max(0.0, std::min({ 1.0, 4.0 * (v - 0.55), 8.0 * (1.0 - v) }));
  return paint;
}

/// Returns a tube around the axis of the eye, which vtkVortexAxis finds.
vtkSmartPointer<vtkTerminationTube> FindEye(vtkAlgorithm* hurricane)
{
  vtkNew<vtkVortexAxis> axis;
  axis->SetInputConnection(hurricane->GetOutputPort());
  axis->Update();
  auto eye = vtkSmartPointer<vtkTerminationTube>::New();
  eye->SetLine(axis->GetOutput());
  eye->SetRadius(EYE);
  return eye;
}

/// Returns an actor for \a surface, whose points are longitudes and latitudes, at height \a z.
vtkSmartPointer<vtkActor> MakeMapActor(vtkAlgorithm* surface, double z, const vtkColor3d& color)
{
  vtkNew<vtkTransform> toMap;
  toMap->Translate(0.0, 0.0, z);
  toMap->Scale(1.0 / DEGREES_EAST, 1.0 / DEGREES_NORTH, 1.0);
  toMap->Translate(-CENTER[0], -CENTER[1], 0.0);
  vtkNew<vtkTransformPolyDataFilter> placed;
  placed->SetInputConnection(surface->GetOutputPort());
  placed->SetTransform(toMap);
  placed->Update();
  return gallery::MakeActor(placed->GetOutput(), color);
}

void AddMap(gallery::Panel& panel)
{
  vtkNew<vtkPlaneSource> sea;
  sea->SetOrigin(WEST, SOUTH, 0.0);
  sea->SetPoint1(EAST, SOUTH, 0.0);
  sea->SetPoint2(WEST, NORTH, 0.0);
  panel.Add(MakeMapActor(sea, SEA - 0.01, { 0.26, 0.42, 0.58 }));
  vtkNew<vtkTriangleFilter> land;
  land->SetInputData(interlume::ReadData("coast.vtp"));
  panel.Add(MakeMapActor(land, SEA, { 0.60, 0.66, 0.50 }));
}

void Build(gallery::Stage& stage)
{
  const vtkSmartPointer<vtkAnalyticFlowSource> hurricane = gallery::MakeUprightHurricane();
  hurricane->SetMaximumWind(0.9);
  hurricane->SetAxisTilt(0.2, 0.1);
  hurricane->SetAxisBend(0.06, -0.04);
  const vtkSmartPointer<vtkTerminationTube> eye = FindEye(hurricane);
  // Only air in the upper half comes from the tube.
  const gallery::FlowGrid samples = { { 121, 121, 57 }, { -1.1, 1.1, -1.1, 1.1, -0.2, 0.49 } };
  const vtkSmartPointer<vtkDataSet> flow =
    gallery::MakeImplicitFlow(hurricane, { eye }, samples, 1.1 * TIME);
  const vtkSmartPointer<vtkImageData> spokes = gallery::MakePaint(512, 256, &UpperSpokes);
  // The dye is released for a limited time and fades out at its front, so that the front is round
  // and stays within the samples, whose boundary is square. The dye also fades in at the tube,
  // since cells that straddle the tube are inaccurate.
  vtkNew<vtkPiecewiseFunction> front;
  front->AddPoint(0.0, 0.0);
  front->AddPoint(0.7, 1.0);
  front->AddPoint(0.95, 1.0);
  front->AddPoint(1.0, 0.0);

  gallery::Panel& panel = stage.AddPanel("", { 0.05, -0.7, 1.0 });
  panel.SetAmbientOcclusion(0.0);
  const vtkSmartPointer<vtkVolume> volume = gallery::MakeInflowVolume(flow, spokes, 0.05);
  vtkImplicitFlowVolumeMapper* mapper = gallery::GetInflowMapper(volume);
  mapper->SetTimeGate(front);
  mapper->TimeGateRepeatOff();
  mapper->SetTimePeriod(TIME);
  mapper->SetTimePhase(1.0);
  // Hides the dye inside the tube in cells that the tube crosses.
  mapper->SetOpacityArray(vtkFlowStatus::SideArray());
  vtkNew<vtkPiecewiseFunction> outside;
  outside->AddPoint(-0.5, 0.0);
  outside->AddPoint(0.0, 1.0);
  volume->GetProperty()->SetScalarOpacity(outside);
  panel.Add(volume);
  // The outer wall is slightly larger than the inflow, since it hides cells that straddle the
  // inflow. The inner wall hides them from the inside.
  const vtkSmartPointer<vtkTexture> paint =
    gallery::MakeInflowTexture(gallery::MakePaint(512, 2, &Spokes), { 0.97, 0.97, 0.97 });
  for (const double radius : { EYE, EYE + 0.01 })
  {
    vtkNew<vtkTerminationTube> wall;
    wall->SetLine(eye->GetLine());
    wall->SetRadius(radius);
    const vtkSmartPointer<vtkActor> tube = gallery::MakeTerminationActor(wall, paint);
    tube->GetProperty()->SetAmbient(0.6);
    tube->GetProperty()->SetDiffuse(0.5);
    panel.Add(tube);
  }
  AddMap(panel);
  panel.Frame(vtkBoundingBox(-0.8, 0.8, -0.7, 0.8, -0.1, 0.3));
}

const gallery::SceneRegistration registration(
  { "hurricane-inflow", "4.17", "A painted cylinder around the eye of a hurricane",
    "An analytic model of a hurricane off the east coast of the United States. Its eye is found in "
    "the wind; a tube around it is painted with spokes. Each point of the volume has the color at "
    "the inflow point of its streamline, if the air passed the tube recently. Map: Natural Earth.",
    { "coast.vtp" }, &Build });
}

// SPDX-License-Identifier: BSD-3-Clause
// A textured cylinder around the eye of a hurricane, above a map.

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Flow/FlowScene.h"
#include "Gallery/Scenes/Flow/InflowPaint.h"
#include "Gallery/Stage.h"

#include "vtkImplicitFlowVolumeMapper.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlaneSource.h"
#include "vtkTerminationCylinder.h"

#include <cmath>

namespace
{
constexpr double EYE = 0.32;
constexpr double TIME = 3.0;

/// Returns the paint of spokes of four colors, crossed by bands that are nearly opaque.
gallery::Paint Spokes(double u, double v)
{
  const double band = 6.0 * v - std::floor(6.0 * v);
  const double spoke = 8.0 * u - std::floor(8.0 * u);
  if (v < 0.06 || v > 0.94 || spoke > 0.6)
  {
    return {};
  }
  return { gallery::IntervalColor(static_cast<int>(8.0 * u) % 4), band < 0.45 ? 0.8 : 0.25 };
}

/// Returns a map with land and sea, from a few sine waves.
vtkSmartPointer<vtkImageData> MakeMap()
{
  return gallery::MakePaint(256, 256,
    [](double u, double v)
    {
      const double coast = 0.42 + 0.13 * std::sin(5.0 * u + 0.4) + 0.05 * std::sin(17.0 * u) +
        0.02 * std::sin(41.0 * u + 1.0);
      const bool isLand = v > coast;
      return gallery::Paint{ isLand ? vtkColor3d(0.56, 0.68, 0.46) : vtkColor3d(0.25, 0.38, 0.55),
        1.0 };
    });
}

void Build(gallery::Stage& stage)
{
  const vtkSmartPointer<vtkAnalyticFlowSource> hurricane = gallery::MakeUprightHurricane();
  vtkNew<vtkTerminationCylinder> eye;
  eye->SetPoint1(0.0, 0.0, -0.5);
  eye->SetPoint2(0.0, 0.0, 0.5);
  eye->SetRadius(EYE);
  const gallery::FlowGrid samples = { { 85, 85, 49 }, { -1.25, 1.25, -1.25, 1.25, -0.48, 0.48 } };
  const vtkSmartPointer<vtkDataSet> flow =
    gallery::MakeImplicitFlow(hurricane, { eye }, samples, 12.0);
  const vtkSmartPointer<vtkImageData> spokes = gallery::MakePaint(512, 256, &Spokes);
  // The dye is released for a limited time and fades at its front. The front is round and remains
  // within the samples, whose boundary is square.
  vtkNew<vtkPiecewiseFunction> front;
  front->AddPoint(0.0, 0.0);
  front->AddPoint(0.25, 1.0);
  front->AddPoint(1.0, 1.0);

  gallery::Panel& panel = stage.AddPanel("", { 0.25, -1.0, 0.85 });
  const vtkSmartPointer<vtkVolume> volume = gallery::MakeInflowVolume(flow, spokes, 0.05);
  vtkImplicitFlowVolumeMapper* mapper = gallery::GetInflowMapper(volume);
  mapper->SetTimeGate(front);
  mapper->TimeGateRepeatOff();
  mapper->SetTimePeriod(TIME);
  mapper->SetTimePhase(1.0);
  panel.Add(volume);
  panel.Add(
    gallery::MakeTerminationActor(eye, gallery::MakeInflowTexture(spokes, { 0.97, 0.97, 0.97 })));
  vtkNew<vtkPlaneSource> ground;
  ground->SetOrigin(-1.2, -1.2, -0.52);
  ground->SetPoint1(1.2, -1.2, -0.52);
  ground->SetPoint2(-1.2, 1.2, -0.52);
  ground->Update();
  const vtkSmartPointer<vtkActor> map = gallery::MakeActor(ground->GetOutput(), { 1.0, 1.0, 1.0 });
  map->SetTexture(gallery::MakeInflowTexture(MakeMap(), { 1.0, 1.0, 1.0 }));
  panel.Add(map);
}

const gallery::SceneRegistration registration(
  { "hurricane-inflow", "4.17", "A painted cylinder around the eye of a hurricane",
    "An analytic model of a hurricane. A cylinder around its eye is painted with spokes and bands. "
    "Each point of the volume has the color at the inflow point of its streamline, if the air "
    "passed the cylinder recently. The map below, with green land and blue sea, is synthetic.",
    {}, &Build });
}

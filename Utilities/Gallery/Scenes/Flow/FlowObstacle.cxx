// SPDX-License-Identifier: BSD-3-Clause
// Flow around a sphere, with three textured time surfaces.

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Flow/FlowScene.h"
#include "Gallery/Scenes/Flow/FlowTextures.h"
#include "Gallery/Stage.h"
#include "Gallery/Volumes.h"

#include "vtkFlowVolume.h"
#include "vtkNew.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double RADIUS = 0.3;

/// z of the inflow plane.
constexpr double START = -1.0;

/// Returns the stream function of the flow around the sphere at a distance \a r from the axis.
double GetStreamFunction(double r, double z)
{
  return r * r * (1.0 - std::pow(RADIUS / std::hypot(r, z), 3.0));
}

/// Returns the distance from the axis at \a z of a streamline between the innermost and the
/// outermost.
double Follow(double outward, double z)
{
  const double value = GetStreamFunction(0.145 + 0.235 * outward, START);
  double lower = std::sqrt(std::max(0.0, RADIUS * RADIUS - z * z));
  double upper = 1.0;
  for (int i = 0; i < 30; ++i)
  {
    const double r = 0.5 * (lower + upper);
    (GetStreamFunction(r, z) < value ? lower : upper) = r;
  }
  return lower;
}

void Build(gallery::Stage& stage)
{
  const vtkSmartPointer<vtkAnalyticFlowSource> flow = gallery::MakeAnalyticFlow(
    vtkAnalyticFlowSource::SPHERE, { { 101, 101, 121 }, { -0.8, 0.8, -0.8, 0.8, -1.1, 1.1 } });
  flow->SetRadius(RADIUS);
  flow->SetVelocity(0.0, 0.0, 1.0);
  const vtkSmartPointer<vtkTerminationPlane> plane =
    gallery::MakeInflowPlane({ 0.0, 0.0, START }, { 0.75, 0.0, 0.0 }, { 0.0, 0.75, 0.0 });
  // The rings follow the streamlines, which are close together at the sphere.
  const vtkSmartPointer<vtkStructuredGrid> samples =
    gallery::MakeRings(nullptr, { { 17, 73, 81 }, { START, 0.9 }, { 0.0, 1.0 }, &Follow });
  const vtkSmartPointer<vtkDataSet> inflow = gallery::MapInflow(
    gallery::MakeImplicitFlow(flow, { plane }, samples), "2 * sqrt((u - 0.5)^2 + (v - 0.5)^2)");
  vtkNew<vtkFlowVolume> filter;
  filter->SetInterval(0, 0.2, 0.5);
  filter->SetTimeSurface(0, 0.5);
  filter->SetTimeSurface(1, 1.15);
  filter->SetTimeSurface(2, 1.75);
  filter->GenerateTimeSurfacesOn();
  filter->ParametersAsTextureCoordinatesOn();
  vtkSmartPointer<vtkUnstructuredGrid> tetrahedra =
    stage.Extract(filter, gallery::AddGradient(inflow, "AdvectionTime"));

  gallery::Panel& panel = stage.AddPanel("", { -1.0, 0.5, 0.9 }, { 0.0, 1.0, 0.0 });
  panel.SetAmbientOcclusion(0.0);
  gallery::LightFromAllSides(panel);
  panel.Add(gallery::MakeVolumeOfIntervals(tetrahedra, { { gallery::IntervalColor(0), 0.6 } }));
  for (int id = 0; id < 3; ++id)
  {
    panel.Add(
      gallery::MakeFlowActor(gallery::GetSmoothFlowSurface(filter, gallery::TIME_SURFACES, id + 1),
        gallery::MakeGridTexture(32, 32, gallery::IntervalColor(1 + id), gallery::TextColor())));
  }
  panel.Add(gallery::MakeSphere({ 0.0, 0.0, 0.0 }, 1.02 * RADIUS, gallery::OutlineColor()));
}

const gallery::SceneRegistration registration(
  { "flow-obstacle", "4.12", "Flow around a sphere, with three time surfaces",
    "Potential flow around a sphere, from the left. The stream volume starts on a ring and "
    "contains three time surfaces: the positions of the flow after three advection times. The flow "
    "carries the grid from the inflow plane and bends it around the obstacle.",
    {}, &Build });
}

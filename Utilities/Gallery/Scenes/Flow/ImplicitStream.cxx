// SPDX-License-Identifier: BSD-3-Clause
// An implicit stream surface, and the stream volume that it bounds.

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Flow/FlowScene.h"
#include "Gallery/Scenes/Flow/InflowPaint.h"
#include "Gallery/Stage.h"
#include "Gallery/Volumes.h"

#include "vtkFlowVolume.h"
#include "vtkNew.h"
#include "vtkStructuredGrid.h"

#include <cmath>

namespace
{
constexpr double GROUND = -0.8;

/// Half the edge length of the square on the ground.
constexpr double HALF_SIZE = 0.95;

/// Contour levels that bound the star. A level is the radius of its contour where the cosine in the
/// formula is 0.
constexpr double INNER = 0.3;
constexpr double OUTER = 0.6;

/// Returns the radius of a streamline at height \a z divided by its radius on the ground.
double Narrow(double z)
{
  return std::sqrt((GROUND + 1.0) / (z + 1.0));
}

/// Returns the color and opacity of the star on the ground.
gallery::Paint Star(double u, double v)
{
  const double x = u - 0.5;
  const double y = v - 0.5;
  const double value = 1.9 * std::hypot(x, y) * (1.0 + 0.25 * std::cos(4.0 * std::atan2(y, x)));
  return { gallery::IntervalColor(2), value > INNER && value < OUTER ? 0.25 : 0.0 };
}

void Build(gallery::Stage& stage)
{
  const vtkSmartPointer<vtkAnalyticFlowSource> tornado = gallery::MakeAnalyticFlow(
    vtkAnalyticFlowSource::TORNADO, { { 49, 49, 33 }, { -1.5, 1.5, -1.5, 1.5, -1.0, 1.0 } });
  tornado->SetCoreRadius(0.6);
  tornado->SetCirculation(1.2);
  const vtkSmartPointer<vtkTerminationPlane> ground = gallery::MakeInflowPlane(
    gallery::GetVortexAxisPoint(tornado, GROUND), { HALF_SIZE, 0.0, 0.0 }, { 0.0, HALF_SIZE, 0.0 });
  // The rings narrow like the streamlines, so that the star is resolved equally well at all
  // heights.
  const vtkSmartPointer<vtkStructuredGrid> samples = gallery::MakeRings(tornado,
    { { 25, 145, 49 }, { GROUND, 1.0 }, { 0.25, 1.25 },
      [](double outward, double z) { return (0.2 + 0.68 * outward) * Narrow(z); } });
  // The contours of the formula are stars with four points.
  const vtkSmartPointer<vtkDataSet> inflow =
    gallery::MapInflow(gallery::MakeImplicitFlow(tornado, { ground }, samples),
      "1.9 * sqrt((u - 0.5)^2 + (v - 0.5)^2) * (1 + 0.25 * cos(4 * atan2(v - 0.5, u - 0.5)))");

  vtkNew<vtkFlowVolume> filter;
  filter->SetInterval(0, INNER, OUTER);
  filter->SetStreamSurface(0, 0.5);
  filter->GenerateStreamSurfacesOn();
  vtkSmartPointer<vtkUnstructuredGrid> tetrahedra =
    stage.Extract(filter, gallery::AddGradient(inflow, "Inflow"));

  const vtkVector3d from(0.25, -1.0, 0.35);
  const vtkSmartPointer<vtkTexture> star =
    gallery::MakeInflowTexture(gallery::MakePaint(512, 512, &Star), { 0.76, 0.79, 0.82 });
  gallery::Panel& surface = stage.AddPanel("the stream surface", from);
  gallery::Panel& volume = stage.AddPanel("the stream volume", from);
  surface.Add(gallery::MakeFlowActor(
    gallery::GetSmoothFlowSurface(filter, gallery::STREAM_SURFACES, 1), gallery::IntervalColor(0)));
  volume.Add(gallery::MakeVolumeOfIntervals(tetrahedra, { { gallery::IntervalColor(0), 5.0 } }));
  for (gallery::Panel* panel : { &surface, &volume })
  {
    panel->Add(gallery::MakeTerminationActor(ground, star));
    // Ambient occlusion would add noise to the ground.
    panel->SetAmbientOcclusion(0.0);
  }
}

const gallery::SceneRegistration registration(
  { "implicit-stream", "4.3", "An implicit stream surface and a stream volume",
    "A vortex that draws air up from the ground, a model of a tornado. Every sample is traced back "
    "to the ground, where a function has the shape of a star (yellow). On the left, a level set of "
    "the resulting field: an implicit stream surface (van Wijk). On the right, the volume between "
    "two levels, extracted from the same samples without further advection.",
    {}, &Build });
}

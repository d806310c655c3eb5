// SPDX-License-Identifier: BSD-3-Clause
// An implicit stream surface, and the stream volume that it bounds.

#include "Gallery/Look.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Flow/FlowScene.h"
#include "Gallery/Stage.h"
#include "Gallery/Volumes.h"

#include "vtkFlowVolume.h"
#include "vtkNew.h"

namespace
{
void Build(gallery::Stage& stage)
{
  const vtkSmartPointer<vtkAnalyticFlowSource> tornado = gallery::MakeAnalyticFlow(
    vtkAnalyticFlowSource::TORNADO, { { 49, 49, 33 }, { -1.5, 1.5, -1.5, 1.5, -1.0, 1.0 } });
  tornado->SetCoreRadius(0.6);
  tornado->SetCirculation(1.2);
  const vtkSmartPointer<vtkTerminationPlane> ground =
    gallery::MakeInflowPlane({ 0.0, 0.0, -0.8 }, { 1.5, 0.0, 0.0 }, { 0.0, 1.5, 0.0 });
  const gallery::FlowGrid samples = { { 57, 57, 61 }, { -0.9, 0.9, -0.9, 0.9, -0.8, 1.0 } };
  // The contours of the formula are stars with four points.
  const vtkSmartPointer<vtkDataSet> inflow =
    gallery::MapInflow(gallery::MakeImplicitFlow(tornado, { ground }, samples),
      "3 * sqrt((u - 0.5)^2 + (v - 0.5)^2) * (1 + 0.25 * cos(4 * atan2(v - 0.5, u - 0.5)))");

  vtkNew<vtkFlowVolume> filter;
  filter->SetInterval(0, 0.3, 0.6);
  filter->GenerateStreamSurfacesOn();
  filter->GenerateNormalsOn();
  vtkSmartPointer<vtkUnstructuredGrid> tetrahedra = stage.Extract(filter, inflow);

  const vtkVector3d from(0.25, -1.0, 0.5);
  gallery::Panel& surface = stage.AddPanel("the stream surface", from);
  gallery::Panel& volume = stage.AddPanel("the stream volume", from);
  surface.Add(gallery::MakeFlowActor(
    gallery::GetFlowSurface(filter, gallery::STREAM_SURFACES, 1), gallery::IntervalColor(0)));
  volume.Add(gallery::MakeVolumeOfIntervals(tetrahedra, { { gallery::IntervalColor(0), 3.0 } }));
}

const gallery::SceneRegistration registration(
  { "implicit-stream", "4.3", "An implicit stream surface and a stream volume",
    "A vortex that draws air up from the ground, a model of a tornado. Every sample is traced back "
    "to the ground, where a function has the shape of a star. On the left, a level set of the "
    "resulting field: an implicit stream surface (van Wijk). On the right, the volume between two "
    "levels, extracted from the same samples without further advection.",
    {}, &Build });
}

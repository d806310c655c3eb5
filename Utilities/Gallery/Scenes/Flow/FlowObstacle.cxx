// SPDX-License-Identifier: BSD-3-Clause
// Flow around a sphere, with three textured time surfaces.

#include "Gallery/Look.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Flow/FlowScene.h"
#include "Gallery/Scenes/Flow/FlowTextures.h"
#include "Gallery/Stage.h"
#include "Gallery/Volumes.h"

#include "vtkFlowVolume.h"
#include "vtkNew.h"

namespace
{
constexpr double RADIUS = 0.3;

void Build(gallery::Stage& stage)
{
  const vtkSmartPointer<vtkAnalyticFlowSource> flow = gallery::MakeAnalyticFlow(
    vtkAnalyticFlowSource::SPHERE, { { 73, 57, 57 }, { -1.1, 1.1, -0.8, 0.8, -0.8, 0.8 } });
  flow->SetRadius(RADIUS);
  const vtkSmartPointer<vtkTerminationPlane> plane =
    gallery::MakeInflowPlane({ -1.0, 0.0, 0.0 }, { 0.0, 0.75, 0.0 }, { 0.0, 0.0, 0.75 });
  const gallery::FlowGrid samples = { { 77, 43, 43 }, { -1.0, 0.9, -0.52, 0.52, -0.52, 0.52 } };
  const vtkSmartPointer<vtkDataSet> inflow = gallery::MapInflow(
    gallery::MakeImplicitFlow(flow, { plane }, samples), "2 * sqrt((u - 0.5)^2 + (v - 0.5)^2)");
  vtkNew<vtkFlowVolume> filter;
  filter->SetInterval(0, 0.22, 0.5);
  filter->SetTimeSurface(0, 0.5);
  filter->SetTimeSurface(1, 1.15);
  filter->SetTimeSurface(2, 1.75);
  filter->GenerateTimeSurfacesOn();
  filter->GenerateNormalsOn();
  filter->ParametersAsTextureCoordinatesOn();
  vtkSmartPointer<vtkUnstructuredGrid> tetrahedra = stage.Extract(filter, inflow);

  gallery::Panel& panel = stage.AddPanel("", { 0.9, -1.0, 0.5 });
  panel.SetAmbientOcclusion(0.0);
  panel.Add(gallery::MakeVolumeOfIntervals(tetrahedra, { { gallery::IntervalColor(0), 0.8 } }));
  for (int id = 0; id < 3; ++id)
  {
    panel.Add(
      gallery::MakeFlowActor(gallery::GetFlowSurface(filter, gallery::TIME_SURFACES, id + 1),
        gallery::MakeGridTexture(32, 32, gallery::IntervalColor(1 + id), gallery::TextColor())));
  }
  panel.Add(gallery::MakeSphere({ 0.0, 0.0, 0.0 }, 1.02 * RADIUS, { 0.8, 0.81, 0.83 }));
}

const gallery::SceneRegistration registration(
  { "flow-obstacle", "4.12", "Flow around a sphere, with three time surfaces",
    "Potential flow around a sphere, from the left. The stream volume starts on a ring and "
    "contains three time surfaces: the positions of the flow after three advection times. The flow "
    "carries the grid from the inflow plane and bends it around the obstacle.",
    {}, &Build });
}

// SPDX-License-Identifier: BSD-3-Clause
// A flow volume between two time surfaces, on which a grid shows how the flow deforms them.

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Flow/FlowScene.h"
#include "Gallery/Scenes/Flow/FlowTextures.h"
#include "Gallery/Stage.h"
#include "Gallery/Volumes.h"

#include "vtkFlowVolume.h"
#include "vtkNew.h"

namespace
{
void Build(gallery::Stage& stage)
{
  const vtkSmartPointer<vtkAnalyticFlowSource> abc = gallery::MakeAnalyticFlow(
    vtkAnalyticFlowSource::ABC, { { 33, 33, 33 }, { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 } });
  const vtkSmartPointer<vtkTerminationPlane> plane =
    gallery::MakeInflowPlane({ 0.0, 0.0, -0.9 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 });
  const gallery::FlowGrid samples = { { 55, 65, 37 }, { -0.6, 0.5, -0.45, 0.85, -0.9, -0.2 } };
  const vtkSmartPointer<vtkDataSet> inflow = gallery::MapInflow(
    gallery::MakeImplicitFlow(abc, { plane }, samples), "sqrt((u - 0.5)^2 + (v - 0.72)^2)");
  vtkNew<vtkFlowVolume> filter;
  filter->SetInterval(0, 0.0, 0.22);
  filter->SetTimeRange(0.08, 0.33);
  filter->GenerateTimeSurfacesOn();
  filter->ParametersAsTextureCoordinatesOn();
  vtkSmartPointer<vtkUnstructuredGrid> tetrahedra =
    stage.Extract(filter, gallery::AddGradient(inflow, "AdvectionTime"));

  gallery::Panel& panel = stage.AddPanel("", { 1.0, 0.45, 0.35 });
  panel.SetAmbientOcclusion(0.0);
  panel.Add(gallery::MakeVolumeOfIntervals(tetrahedra, { { gallery::IntervalColor(0), 1.5 } }));
  for (int id = 0; id < 2; ++id)
  {
    panel.Add(
      gallery::MakeFlowActor(gallery::GetSmoothFlowSurface(filter, gallery::TIME_SURFACES, id),
        gallery::MakeGridTexture(24, 24, gallery::IntervalColor(1 + id), gallery::TextColor())));
  }
}

const gallery::SceneRegistration registration(
  { "time-surfaces", "4.11", "A flow volume between two time surfaces with a grid",
    "Flow through a disk in an Arnold-Beltrami-Childress flow, from 0.08 (green) to 0.33 (yellow) "
    "units of time after it passes the disk. The flow carries a grid of squares from the disk. The "
    "grid shows how the flow rotates, stretches and shears.",
    {}, &Build });
}

// SPDX-License-Identifier: BSD-3-Clause
// A flow volume with one of its two boundary surfaces highlighted.

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Flow/FlowScene.h"
#include "Gallery/Stage.h"
#include "Gallery/Volumes.h"

#include "vtkCubeSource.h"
#include "vtkFlowVolume.h"
#include "vtkNew.h"

namespace
{
constexpr double TOP = 1.0;

void Build(gallery::Stage& stage)
{
  const vtkSmartPointer<vtkAnalyticFlowSource> jet = gallery::MakeAnalyticFlow(
    vtkAnalyticFlowSource::SADDLE, { { 17, 17, 17 }, { -1.3, 1.3, -0.9, 0.9, 0.0, TOP } });
  jet->SetSaddleRates(0.65, 0.35, -1.0);
  const vtkSmartPointer<vtkTerminationPlane> nozzle =
    gallery::MakeInflowPlane({ 0.0, 0.0, TOP }, { 0.5, 0.0, 0.0 }, { 0.0, 0.5, 0.0 });
  const gallery::FlowGrid samples = { { 81, 65, 41 }, { -1.3, 1.3, -0.9, 0.9, 0.02, TOP } };
  const vtkSmartPointer<vtkDataSet> inflow = gallery::MapInflow(
    gallery::MakeImplicitFlow(jet, { nozzle }, samples), "sqrt((u - 0.5)^2 + (v - 0.5)^2)");

  vtkNew<vtkFlowVolume> filter;
  filter->SetInterval(0, 0.16, 0.42);
  filter->GenerateStreamSurfacesOn();
  vtkSmartPointer<vtkUnstructuredGrid> tetrahedra =
    stage.Extract(filter, gallery::AddGradient(inflow, "Inflow"));

  gallery::Panel& panel = stage.AddPanel("", { 0.2, -1.0, 0.4 });
  panel.SetAmbientOcclusion(0.0);
  vtkSmartPointer<vtkVolume> volume =
    gallery::MakeVolumeOfIntervals(tetrahedra, { { gallery::IntervalColor(0), 0.8 } });
  gallery::SetBoundary(volume, gallery::GetSmoothFlowSurface(filter, gallery::STREAM_SURFACES, 0),
    gallery::IntervalColor(2), 1.0);
  panel.Add(volume);
  vtkNew<vtkCubeSource> floor;
  floor->SetBounds(-1.3, 1.3, -0.9, 0.9, -0.06, 0.0);
  floor->Update();
  panel.Add(gallery::MakeActor(floor->GetOutput(), { 0.76, 0.79, 0.82 }));
}

const gallery::SceneRegistration registration(
  { "flow-volume-boundary", "4.5", "A flow volume with one boundary surface",
    "A jet that flows down onto a floor. It spreads more to the left and right "
    "than to the front and back: a saddle with velocity (0.65 x, 0.35 y, -z). The stream volume "
    "starts on a ring at the top. Its inner boundary, opaque and glossy, is a stream surface that "
    "the same pass extracts.",
    {}, &Build });
}

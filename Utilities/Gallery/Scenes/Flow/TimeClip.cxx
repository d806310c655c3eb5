// SPDX-License-Identifier: BSD-3-Clause
// A stream volume that is clipped by advection time and contains stream surfaces and time surfaces.

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
#include "vtkTerminationSphere.h"

namespace
{
const vtkColor3d VOLUME = gallery::IntervalColor(0);
constexpr int OUTER_SURFACE = 2;

/// Runs \a filter. Adds a panel with its volume and its time surfaces with ids \a first to \a last.
gallery::Panel& Show(gallery::Stage& stage, vtkFlowVolume* filter, vtkDataSet* inflow,
  const char* caption, int first, int last)
{
  filter->SetInterval(0, 0.0, 0.35);
  filter->SetStreamSurface(0, 0.14);
  filter->GenerateTimeSurfacesOn();
  filter->GenerateStreamSurfacesOn();
  filter->GenerateNormalsOn();
  filter->ParametersAsTextureCoordinatesOn();
  vtkSmartPointer<vtkUnstructuredGrid> tetrahedra = stage.Extract(filter, inflow);
  gallery::Panel& panel = stage.AddPanel(caption);
  panel.LookFrom({ 0.5, -1.0, 0.3 }, { 0.0, 0.0, 1.0 });
  panel.SetAmbientOcclusion(0.0);
  gallery::LightFromAllSides(panel);
  panel.Add(gallery::MakeSphere({ 0.0, 0.0, -0.5 }, 0.12, gallery::IntervalColor(3)));
  panel.Add(gallery::MakeSphere({ 0.0, 0.0, 0.5 }, 0.12, gallery::IntervalColor(0)));
  panel.Add(gallery::MakeVolumeOfIntervals(tetrahedra, { { VOLUME, 2.5 } }));
  for (int id = first; id <= last; ++id)
  {
    panel.Add(
      gallery::MakeFlowActor(gallery::GetSmoothFlowSurface(filter, gallery::TIME_SURFACES, id),
        gallery::MakeGridTexture(24, 32, gallery::IntervalColor(2), gallery::TextColor())));
  }
  return panel;
}

void Build(gallery::Stage& stage)
{
  const vtkSmartPointer<vtkAnalyticFlowSource> charges = gallery::MakeAnalyticFlow(
    vtkAnalyticFlowSource::COUPLED_CHARGE, { { 81, 81, 81 }, { -1.3, 1.3, -1.3, 1.3, -1.3, 1.3 } });
  charges->SetSeparation(0.0, 0.0, 1.0);
  vtkNew<vtkTerminationSphere> source;
  source->SetCenter(0.0, 0.0, -0.5);
  source->SetRadius(0.1);
  const vtkSmartPointer<vtkStructuredGrid> samples =
    gallery::MakeArcs({ { 29, 41, 57 } }, { { 0.0, 0.5 } });
  const vtkSmartPointer<vtkDataSet> inflow = gallery::AddGradient(
    gallery::MapInflow(gallery::MakeImplicitFlow(charges, { source }, samples), "1 - v"),
    "AdvectionTime");

  vtkNew<vtkFlowVolume> clipped;
  clipped->SetTimeRange(0.015, 0.06);
  gallery::Panel& left = Show(stage, clipped, inflow, "(a) clipped to a range of time", 0, 1);
  left.Add(gallery::MakeFlowActor(
    gallery::GetFlowSurface(clipped, gallery::STREAM_SURFACES, OUTER_SURFACE),
    gallery::MakeGridTexture(24, 1, gallery::IntervalColor(1), gallery::TextColor())));

  vtkNew<vtkFlowVolume> full;
  const double times[3] = { 0.015, 0.035, 0.06 };
  for (int i = 0; i < 3; ++i)
  {
    full->SetTimeSurface(i, times[i]);
  }
  gallery::Panel& right =
    Show(stage, full, inflow, "(b) three time surfaces, one stream surface", 1, 3);
  right.Add(gallery::MakeFlowActor(gallery::GetFlowSurface(full, gallery::STREAM_SURFACES, 1),
    gallery::MakeGridTexture(24, 1, gallery::IntervalColor(1), gallery::TextColor())));
}

const gallery::SceneRegistration registration(
  { "time-clip", "4.13", "A stream volume clipped by time, and with surfaces inside",
    "The field of two charges of opposite sign, cut in half, with the source (red) below and the "
    "sink (blue) above. (a) The stream volume between two advection times, with its stream surface "
    "(green, with streamlines) and its time surfaces (yellow, with a grid that the flow carries). "
    "(b) The complete volume with three time surfaces and a stream surface inside.",
    {}, &Build });
}

// SPDX-License-Identifier: BSD-3-Clause
// The boundary of an interval volume as a textured stream surface.

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Flow/TexturedSurface.h"
#include "Gallery/Stage.h"
#include "Gallery/Volumes.h"

#include "vtkIntervalVolume.h"
#include "vtkPointData.h"

namespace
{
/// Range of advection times: from a place inside the rim to the top.
constexpr double START = 0.45;
constexpr double END = 6.0;

/// Few enough lines to fit everywhere on the surface, so that no line fades.
constexpr int LINES = 32;

void Build(gallery::Stage& stage)
{
  gallery::MappedFlow flow = gallery::MakeTornado(6.5, 2);
  flow.Samples = gallery::AddGradient(flow.Samples, "Inflow");
  const vtkSmartPointer<vtkPolyData> surface =
    gallery::MakeTexturedSurface(flow, 0.06, START, END, 16.0);
  gallery::SetGradientNormals(surface->GetPointData(), vtkIntervalVolume::LOWER_SIDE);
  gallery::Panel& panel = stage.AddPanel("", { 0.4, -1.0, 0.35 });
  panel.Add(gallery::MakeActorWithLines(surface, gallery::IntervalColor(2),
    gallery::MakeArcLengthTexture(16, gallery::TextColor(), LINES), nullptr));
  panel.Add(gallery::MakeVolumeOfIntervals(
    gallery::MakeStreamVolume(gallery::MakeTornado(6.5).Samples, 0.06, 0.16, START, END),
    { { gallery::IntervalColor(0), 1.8 } }));
  // The upper end is above the image.
  panel.Frame(vtkBoundingBox(-0.85, 0.85, -0.1, 0.1, -1.16, 0.05));
}

const gallery::SceneRegistration registration(
  { "interval-textured", "3.8", "The boundary of an interval as a textured stream surface",
    "Air of a tornado that enters at relative heights from 0.06 to 0.16: an interval volume of the "
    "inflow height. Its inner boundary is a stream surface. It is opaque, with lines that follow "
    "the flow, and visible through the translucent volume.",
    {}, &Build });
}

// SPDX-License-Identifier: BSD-3-Clause
// The boundary of an interval volume as a textured stream surface.

#include "Gallery/Look.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Flow/TexturedSurface.h"
#include "Gallery/Stage.h"
#include "Gallery/Volumes.h"

namespace
{
/// Maximum advection time. It cuts off the upper part of the flow, a straight tube.
constexpr double END = 5.0;

void Build(gallery::Stage& stage)
{
  const gallery::MappedFlow flow = gallery::MakeTornado(12.0);
  gallery::Panel& panel = stage.AddPanel("", { 0.4, -1.0, 0.35 });
  panel.Add(gallery::MakeActorWithLines(gallery::MakeTexturedSurface(flow, 0.06, 0.45, END, 16.0),
    vtkColor3d(0.95, 0.93, 0.9), gallery::MakeArcLengthTexture(48, gallery::TextColor(), 16),
    nullptr));
  panel.Add(
    gallery::MakeVolumeOfIntervals(gallery::MakeStreamVolume(flow.Samples, 0.06, 0.16, 0.45, END),
      { { gallery::IntervalColor(0), 2.0 } }));
}

const gallery::SceneRegistration registration(
  { "interval-textured", "3.8", "The boundary of an interval as a textured stream surface",
    "Air of a tornado that enters at relative heights from 0.06 to 0.16: an interval volume of the "
    "inflow height. Its inner boundary is a stream surface. It is opaque, with lines that follow "
    "the flow, and visible through the translucent volume.",
    {}, &Build });
}

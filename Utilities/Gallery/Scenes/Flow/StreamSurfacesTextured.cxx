// SPDX-License-Identifier: BSD-3-Clause
// Streamlines and timelines on a stream surface, and nested surfaces with different textures.

#include "Gallery/Look.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Flow/TexturedSurface.h"
#include "Gallery/Stage.h"

#include "vtkProperty.h"

#include <array>

namespace
{
/// Inflow values of the surfaces.
constexpr double INNER = 0.05;
constexpr double OUTER = 0.13;

/// Advection time at the lower edge of the surfaces, and advection time covered by LINES timelines.
constexpr double START = 0.45;
constexpr double PERIOD = 8.0;

/// Few enough lines to fit everywhere on the surfaces, so that no line ends on them.
constexpr int LINES = 32;

void Build(gallery::Stage& stage)
{
  const gallery::MappedFlow flow = gallery::MakeTornado(6.0, 2);
  gallery::Panel& one = stage.AddPanel("streamlines and timelines");
  gallery::Panel& nested = stage.AddPanel("two nested surfaces");
  for (gallery::Panel* panel : { &one, &nested })
  {
    panel->LookFrom({ 0.4, -1.0, 0.5 }, { 0.0, 0.0, 1.0 });
  }

  const vtkSmartPointer<vtkPolyData> outer =
    gallery::MakeTexturedSurface(flow, OUTER, START, 3.9, PERIOD);
  one.Add(gallery::MakeActorWithLines(outer, gallery::IntervalColor(0),
    gallery::MakeArcLengthTexture(16, gallery::TextColor(), LINES),
    gallery::MakeTimelineTexture(16, vtkColor3d(1.0, 1.0, 1.0), LINES)));

  // Two actors that overlap behind the inner surface leave a wedge open in front of it.
  for (const std::array<double, 3>& normal :
    { std::array<double, 3>{ { -0.84, 0.55, 0.0 } }, std::array<double, 3>{ { 0.23, 0.97, 0.0 } } })
  {
    const vtkSmartPointer<vtkActor> open =
      gallery::MakeActorWithLines(outer, gallery::IntervalColor(0),
        gallery::MakeArcLengthTexture(16, gallery::TextColor(), LINES), nullptr);
    gallery::ClipActor(open, normal);
    // Brightens the inside.
    open->GetProperty()->SetAmbient(0.3);
    nested.Add(open);
  }
  nested.Add(gallery::MakeActorWithLines(
    gallery::MakeTexturedSurface(flow, INNER, START, 5.5, PERIOD), gallery::IntervalColor(1),
    nullptr, gallery::MakeTimelineTexture(16, gallery::TextColor(), LINES)));
}

const gallery::SceneRegistration registration(
  { "stream-surfaces-textured", "4.7", "Streamlines and timelines as textures",
    "Stream surfaces of a tornado, each of the air that enters at one height. Left: dark "
    "streamlines, and white timelines, which air reaches at the same time. Right: the same "
    "surface, cut open, with streamlines only, and inside it, with timelines, the surface of air "
    "that enters closer to the ground. The lines are a texture. The arc length along the inflow "
    "circle and the advection time are the texture coordinates.",
    {}, &Build });
}

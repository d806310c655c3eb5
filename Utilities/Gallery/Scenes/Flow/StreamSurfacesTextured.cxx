// SPDX-License-Identifier: BSD-3-Clause
// Streamlines and timelines on a stream surface, and nested surfaces with different textures.

#include "Gallery/Look.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Flow/TexturedSurface.h"
#include "Gallery/Stage.h"

namespace
{
void Build(gallery::Stage& stage)
{
  const gallery::MappedFlow flow = gallery::MakeTornado(7.0);
  const vtkVector3d from(0.4, -1.0, 0.5);
  gallery::Panel& one = stage.AddPanel("streamlines and timelines", from);
  gallery::Panel& nested = stage.AddPanel("two nested surfaces", from);

  const vtkSmartPointer<vtkPolyData> outer =
    gallery::MakeTexturedSurface(flow, 0.13, 0.45, 3.9, 16.0);
  one.Add(gallery::MakeLinedActor(outer, gallery::IntervalColor(0),
    gallery::MakeStreamlines(64, gallery::Ink()),
    gallery::MakeTimelines(72, vtkColor3d(1.0, 1.0, 1.0))));

  const vtkSmartPointer<vtkActor> open = gallery::MakeLinedActor(
    outer, gallery::IntervalColor(0), gallery::MakeStreamlines(48, gallery::Ink()), nullptr);
  gallery::CutOpen(open, { -0.4, 1.0, 0.0 });
  nested.Add(open);
  nested.Add(gallery::MakeLinedActor(gallery::MakeTexturedSurface(flow, 0.05, 0.45, 5.5, 16.0),
    gallery::IntervalColor(1), nullptr, gallery::MakeTimelines(48, gallery::Ink())));
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

// SPDX-License-Identifier: BSD-3-Clause
// Streamlines by a texture that is not averaged: more lines the nearer the surface is.

#include "Gallery/Look.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Flow/TexturedSurface.h"
#include "Gallery/Stage.h"

namespace
{
void Build(gallery::Stage& stage)
{
  const vtkSmartPointer<vtkPolyData> surface =
    gallery::MakeTexturedSurface(gallery::MakeTornado(5.0), 0.13, 0.45, 3.9, 16.0);
  // One texture for all.
  const vtkSmartPointer<vtkStreamlineTexture> lines = gallery::MakeStreamlines(48, gallery::Ink());
  const struct
  {
    const char* Caption;
    double Size;
  } views[] = { { "from far", 1.0 }, { "three times nearer", 1.0 / 3.0 },
    { "nine times nearer", 1.0 / 9.0 } };
  double bounds[6];
  surface->GetBounds(bounds);
  // On the near side.
  const double middle[3] = { 0.0, -0.47, -0.3 };
  for (const auto& view : views)
  {
    gallery::Panel& panel = stage.AddPanel(view.Caption);
    panel.LookFrom({ 0.4, -1.0, 0.5 }, { 0.0, 0.0, 1.0 });
    panel.Add(gallery::MakeLinedActor(surface, gallery::IntervalColour(0), lines, nullptr));
    if (view.Size < 1.0)
    {
      // The part that is as large as the distance says, about the same point.
      double part[6];
      for (int i = 0; i < 6; ++i)
      {
        part[i] = middle[i / 2] + view.Size * (bounds[i] - middle[i / 2]);
      }
      panel.Frame(vtkBoundingBox(part));
    }
  }
}

const gallery::SceneRegistration registration(
  { "streamline-zoom", "4.8", "More streamlines the nearer the surface is",
    "A stream surface of a tornado from three distances, with the same texture: a pyramid whose "
    "levels hold fewer and fewer lines of the same width in texels, and none of which is the mean "
    "of another. Lines fade in between those that are there, about as far apart on screen at any "
    "distance.",
    {}, &Build });
}

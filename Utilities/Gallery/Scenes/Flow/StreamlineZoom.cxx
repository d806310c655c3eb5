// SPDX-License-Identifier: BSD-3-Clause
// Streamlines as a texture whose mipmap levels are not averages: line density increases as the
// camera approaches.

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
  // All panels share one texture.
  const vtkSmartPointer<vtkStreamlineTexture> lines = gallery::MakeStreamlines(48, gallery::Ink());
  const struct
  {
    const char* Caption;
    double Size;
  } views[] = { { "from far", 1.0 }, { "three times nearer", 1.0 / 3.0 },
    { "nine times nearer", 1.0 / 9.0 } };
  double bounds[6];
  surface->GetBounds(bounds);
  // A point on the part of the surface that faces the camera.
  const double center[3] = { 0.0, -0.47, -0.3 };
  for (const auto& view : views)
  {
    gallery::Panel& panel = stage.AddPanel(view.Caption);
    panel.LookFrom({ 0.4, -1.0, 0.5 }, { 0.0, 0.0, 1.0 });
    panel.Add(gallery::MakeLinedActor(surface, gallery::IntervalColor(0), lines, nullptr));
    if (view.Size < 1.0)
    {
      // Frames the bounds of the surface, scaled by Size around the center.
      double part[6];
      for (int i = 0; i < 6; ++i)
      {
        part[i] = center[i / 2] + view.Size * (bounds[i] - center[i / 2]);
      }
      panel.Frame(vtkBoundingBox(part));
    }
  }
}

const gallery::SceneRegistration registration(
  { "streamline-zoom", "4.8", "More streamlines at closer distances",
    "A stream surface of a tornado from three distances, with the same texture: a mipmap pyramid "
    "whose levels have fewer and fewer lines of constant width in texels. No level is the average "
    "of another. New lines fade in between existing ones, so that their distance on screen is "
    "about the same at any distance of the camera.",
    {}, &Build });
}

// SPDX-License-Identifier: BSD-3-Clause
// Stripes of light on a cube.

#include "Gallery/Panel.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/LightScreens.h"
#include "Gallery/Scenes/Light/ShadowScene.h"

#include <cmath>

namespace
{
void Build(gallery::Stage& stage)
{
  const vtkBoundingBox box(-1.65, 1.65, -0.95, 1.15, -0.08, 1.35);
  vtkSmartPointer<vtkSpatialObject> cube = gallery::Place(
    gallery::MakeBox({ -0.36, -0.36, 0.0 }, { 0.36, 0.36, 0.72 }, { 0.90, 0.62, 0.34 }),
    { 0.0, -0.05, 0.02 }, 25.0);
  vtkSmartPointer<vtkImageData> image = gallery::Sample(
    gallery::SoftenEdges(
      gallery::Unite(
        { gallery::MakeBox({ -1.6, -0.9, -0.05 }, { 1.6, 1.028, 0.0 }, gallery::PlasterColor()),
          gallery::MakeBox({ -1.6, 1.05, -0.05 }, { 1.6, 1.1, 1.3 }, gallery::PlasterColor()),
          cube }),
      0.012),
    box, 420, 1.3);
  vtkSmartPointer<vtkImageData> stripes = gallery::MakePattern(1024, 16,
    [](double u, double)
    {
      const double gray = std::fmod(16.0 * u, 1.0) < 0.5 ? 1.0 : 0.12;
      return vtkColor3d(gray, gray, gray);
    });
  vtkSmartPointer<vtkProjectiveLight> light =
    gallery::MakeProjector({ -1.7, -3.3, 2.6 }, { 0.0, 0.1, 0.35 }, 4.4, 4.4, 1.85, stripes);
  light->SetViewUp(-0.6, 0.0, 1.0);

  gallery::AddPatternPanel(stage, image, light).LookFrom({ 0.0, -1.0, 0.5 }, { 0.0, 0.0, 1.0 });
}

const gallery::SceneRegistration registration(
  { "light-stripes", "2.19", "Stripes of light on a cube",
    "A point light shines through a screen with stripes. The stripes change direction at the edges "
    "of the cube, on the ground and on the wall, and the cube casts its shadow on them. A "
    "constructive volume.",
    {}, &Build });
}

// SPDX-License-Identifier: BSD-3-Clause
// Rings of light on simple shapes.

#include "Gallery/Panel.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/LightScreens.h"
#include "Gallery/Scenes/Light/ShadowScene.h"

#include "vtkRenderer.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkVolumeCollection.h"

#include <cmath>

namespace
{
vtkSmartPointer<vtkSpatialPrimitive> MakeRound(
  int shape, const vtkVector3d& center, double radius, double height, const vtkColor3d& color)
{
  auto round = vtkSmartPointer<vtkSpatialPrimitive>::New();
  round->SetShape(shape);
  round->SetCenter(center[0], center[1], center[2]);
  round->SetRadius(radius);
  round->SetHeight(height);
  round->SetEdgeWidth(gallery::EDGE_WIDTH);
  round->SetColor(color[0], color[1], color[2]);
  return round;
}

void Build(gallery::Stage& stage)
{
  const vtkBoundingBox box(-1.65, 1.65, -1.0, 1.05, -0.08, 1.4);
  vtkSmartPointer<vtkSpatialObject> cube = gallery::Place(
    gallery::MakeBox({ -0.25, -0.25, 0.0 }, { 0.25, 0.25, 0.5 }, { 0.74, 0.40, 0.34 }),
    { 0.70, 0.0, 0.022 }, 6.0);
  vtkSmartPointer<vtkImageData> image = gallery::Sample(
    gallery::Unite(
      { gallery::MakeBox({ -1.6, -0.95, -0.05 }, { 1.6, 0.928, 0.0 }, gallery::PlasterColor()),
        gallery::MakeBox({ -1.6, 0.95, -0.05 }, { 1.6, 1.0, 1.35 }, gallery::PlasterColor()), cube,
        MakeRound(
          vtkSpatialPrimitive::SPHERE, { -0.12, -0.25, 0.35 }, 0.34, 1.0, { 0.90, 0.60, 0.30 }),
        MakeRound(vtkSpatialPrimitive::CYLINDER, { -0.72, 0.35, 0.442 }, 0.2, 0.84,
          { 0.36, 0.50, 0.68 }) }),
    box, 280);
  vtkSmartPointer<vtkImageData> rings = gallery::MakePattern(512, 512,
    [](double u, double v)
    {
      const double radius = 2.0 * std::hypot(u - 0.5, v - 0.5);
      const double wave = std::cos(2.0 * 3.14159265358979323846 * 6.0 * radius);
      const double gray = 0.56 + 0.44 * std::tanh(4.0 * wave);
      return vtkColor3d(gray, 0.95 * gray, 0.86 * gray);
    });
  vtkSmartPointer<vtkProjectiveLight> light =
    gallery::MakeProjector({ -1.7, -3.0, 3.4 }, { 0.0, 0.1, 0.3 }, 3.4, 3.4, 2.2, rings);
  light->SetEdgeWidth(0.5);

  gallery::Panel& panel = gallery::AddPatternPanel(stage, image, light);
  // With a smaller light buffer, a weave would be visible on the sphere and the cube.
  gallery::GetSlicedMapper(
    vtkVolume::SafeDownCast(panel.GetRenderer()->GetVolumes()->GetItemAsObject(0)))
    ->SetLightBufferSize(1024);
  panel.LookFrom({ 0.0, -1.0, 0.5 }, { 0.0, 0.0, 1.0 });
}

const gallery::SceneRegistration registration(
  { "light-rings", "2.18", "Rings of light on simple shapes",
    "A point light shines through a screen with rings, which follow the shapes that they "
    "illuminate. The shapes cast shadows. The screen has a smooth edge, so the light fades out "
    "gradually. The shapes are a constructive volume.",
    {}, &Build });
}

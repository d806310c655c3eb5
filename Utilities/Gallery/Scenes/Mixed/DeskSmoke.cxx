// SPDX-License-Identifier: BSD-3-Clause
// A polygonal desk in a smoky room with the sun in its window.

#include "Gallery/Look.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/LightScreens.h"
#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Gallery/Scenes/Mixed/ModelActors.h"
#include "Gallery/Stage.h"

#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkShadowedScenePass.h"
#include "vtkSpatialTurbulence.h"

namespace
{
using namespace interlume;

/// Returns a polygonal box from \a lower to \a upper.
ModelPart MakeBlock(
  const Position3& lower, const Position3& upper, const vtkColor3d& color, double edge = 0.01)
{
  Position3 lengths;
  Position3 center;
  for (std::size_t k = 0; k < 3; ++k)
  {
    lengths[k] = upper[k] - lower[k];
    center[k] = 0.5 * (lower[k] + upper[k]);
  }
  return { MoveShape(MakeRoundedBox(lengths, edge), center), { { color[0], color[1], color[2] } },
    0.05 };
}

/// Returns a floor, walls and a ceiling, with a window in the wall at +y.
Model MakeShell()
{
  const vtkColor3d plaster(0.94, 0.82, 0.66);
  const vtkColor3d floor(0.62, 0.47, 0.34);
  const vtkColor3d frame(0.52, 0.36, 0.24);
  Model shell = { MakeBlock({ { -1.3, -1.1, -0.06 } }, { { 1.3, 1.06, 0.0 } }, floor),
    MakeBlock({ { -1.3, -1.1, -0.02 } }, { { -1.24, 1.06, 1.6 } }, plaster),
    MakeBlock({ { 1.24, -1.1, -0.02 } }, { { 1.3, 1.06, 1.6 } }, plaster),
    MakeBlock({ { -1.3, -1.1, 1.58 } }, { { 1.3, 1.06, 1.64 } }, plaster),
    MakeBlock({ { -1.3, 1.0, -0.02 } }, { { -0.7, 1.06, 1.6 } }, plaster),
    MakeBlock({ { 0.3, 1.0, -0.02 } }, { { 1.3, 1.06, 1.6 } }, plaster),
    MakeBlock({ { -0.72, 1.0, -0.02 } }, { { 0.32, 1.06, 0.6 } }, plaster),
    MakeBlock({ { -0.72, 1.0, 1.36 } }, { { 0.32, 1.06, 1.6 } }, plaster),
    MakeBlock({ { -0.72, 0.99, 0.96 } }, { { 0.32, 1.04, 1.0 } }, frame),
    MakeBlock({ { -0.22, 0.99, 0.58 } }, { { -0.18, 1.04, 1.38 } }, frame),
    MakeBlock({ { -0.76, 0.9, 0.56 } }, { { 0.36, 1.04, 0.6 } }, frame) };
  return shell;
}

/// Returns turbulent smoke that fills the room.
vtkSmartPointer<vtkVolume> MakeSmoke()
{
  const vtkColor3d white(1.0, 0.97, 0.92);
  vtkSmartPointer<vtkSpatialPrimitive> air =
    gallery::MakeBox({ -1.22, -1.08, 0.02 }, { 1.22, 0.98, 1.56 }, white);
  air->SetEdgeWidth(0.04);
  air->SetDensity(0.5);
  vtkNew<vtkSpatialTurbulence> smoke;
  smoke->SetOperand(air);
  smoke->SetModeToModulation();
  smoke->SetSum(vtkTurbulenceSource::FRACTAL_SUM);
  smoke->SetFrequency(2.4);
  smoke->SetAmplitude(1.3);
  vtkSmartPointer<vtkImageData> image =
    gallery::Sample(smoke, vtkBoundingBox(-1.23, 1.23, -1.1, 0.99, 0.01, 1.57), 130);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(70.0, 0.1);
  opacity->AddPoint(255.0, 0.75);
  vtkSmartPointer<vtkVolumeProperty> medium = gallery::MakeColoredMedium(opacity, 1.0);
  medium->SetAmbient(0.05);
  medium->SetDiffuse(1.0);
  medium->SetSpecular(0.0);
  return gallery::MakeSlicedVolume(image, medium, 1.0);
}

void Build(gallery::Stage& stage)
{
  Model desk = MakeDesk();
  Append(desk, Move(MakeLamp(), { { -0.42, 0.12, 0.72 } }, { { 0.0, 0.0, -30.0 } }));
  Append(desk, Move(MakeBooks(), { { 0.36, 0.04, 0.72 } }));
  Append(desk, Move(MakeMug(), { { 0.06, -0.08, 0.72 } }, { { 0.0, 0.0, -40.0 } }));
  gallery::Panel& panel = stage.AddPanel("", { 0.12, -1.0, 0.1 });
  gallery::AddModel(panel, MakeShell());
  gallery::AddModel(panel, Move(desk, { { 0.46, 0.3, 0.0 } }, { { 0.0, 0.0, 6.0 } }));
  gallery::AddModel(panel, Move(MakeChair(), { { -0.42, -0.1, 0.0 } }, { { 0.0, 0.0, -38.0 } }));
  panel.Add(MakeSmoke());
  gallery::UseSceneShadows(panel);
  vtkShadowedScenePass::SafeDownCast(panel.GetRenderer()->GetPass())->SetDepthMapResolution(4096);
  vtkSmartPointer<vtkLight> sun = gallery::MakeParallelLight({ 0.45, 1.0, 0.75 }, 4.8);
  sun->SetDiffuseColor(1.0, 0.87, 0.68);
  panel.SetLights({ sun, gallery::MakeFillLight({ 0.3, -1.0, 0.6 }, 0.6) });
  // The background is the sky, which is visible only through the window.
  panel.SetBackground(vtkColor3d(0.74, 0.82, 0.92));
  panel.Frame(vtkBoundingBox(-1.08, 1.08, -1.0, -0.99, 0.1, 1.45));
}

const gallery::SceneRegistration registration({ "desk-smoke", "2.46", "A desk in a smoky room",
  "The room, the desk, the chair and the objects on the desk consist of polygons, the turbulent "
  "smoke is a volume. The sun shines through the window at the back. Its light is visible in the "
  "smoke, with "
  "the shadows of the window bars and of the furniture.",
  {}, &Build });
}

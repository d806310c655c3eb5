// SPDX-License-Identifier: BSD-3-Clause
// A polygonal teapot within a translucent cube.

#include "Gallery/Look.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/LightScreens.h"
#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Gallery/Scenes/Mixed/ModelActors.h"
#include "Gallery/Stage.h"

#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkShadowedScenePass.h"

namespace
{
void Build(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image =
    gallery::Sample(gallery::MakeBox({ -0.9, -0.6, 0.0 }, { 0.9, 0.6, 1.3 }, { 0.66, 0.86, 0.90 }),
      vtkBoundingBox(-1.0, 1.0, -0.7, 0.7, -0.1, 1.4), 180, 0.9);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(255.0, 0.42);
  vtkSmartPointer<vtkVolumeProperty> medium = gallery::MakeColoredMedium(opacity, 1.0);
  medium->SetAmbient(0.15);
  medium->SetDiffuse(0.95);
  medium->SetSpecular(0.0);
  gallery::Panel& panel = stage.AddPanel("", { 0.25, -1.0, 0.5 });
  // The maximum surface gradient makes scattering nearly isotropic, so that edges are not shaded.
  panel.Add(gallery::MakeSlicedVolume(image, medium, 1.0));
  gallery::AddModel(panel,
    interlume::Move(interlume::MakeTeapot(), { { 0.0, 0.0, 0.005 } }, { { 0.0, 0.0, 42.0 } }));
  gallery::AddGround(panel, { { 0.0, 0.0, -0.02 } }, 2.4, 1.0, { { 0.86, 0.78, 0.68 } });
  gallery::UseSceneShadows(panel);
  auto* pass = vtkShadowedScenePass::SafeDownCast(panel.GetRenderer()->GetPass());
  pass->SetDepthMapResolution(4096);
  pass->SetDepthBias(3.0);
  panel.SetLights({ gallery::MakePointLight({ -2.8, -2.0, 3.2 }, 1.25),
    gallery::MakeFillLight({ 1.0, -1.0, 0.5 }, 0.25) });
  panel.SetBackground({ 0.84, 0.80, 0.74 }, { 0.34, 0.34, 0.40 });
  panel.Frame(vtkBoundingBox(-1.15, 1.25, -0.1, 0.1, -0.45, 1.42));
}

const gallery::SceneRegistration registration(
  { "teapot-cube", "2.45", "A teapot within a translucent cube",
    "The teapot consists of polygons, the cube around it is a volume. The handle casts its "
    "shadow on the pot, and the pot on the spout. The teapot's shadow extends through the "
    "translucent medium to the ground.",
    {}, &Build });
}

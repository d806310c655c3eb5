// SPDX-License-Identifier: BSD-3-Clause
// A teapot of polygons within a translucent cube.

#include "Gallery/Look.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/LightScreens.h"
#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Gallery/Scenes/Mixed/ModelActors.h"
#include "Gallery/Stage.h"

#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"

namespace
{
void Build(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image =
    gallery::Sample(gallery::MakeBox({ -0.9, -0.6, 0.0 }, { 0.9, 0.6, 1.3 }, { 0.50, 0.72, 0.78 }),
      vtkBoundingBox(-1.0, 1.0, -0.7, 0.7, -0.1, 1.4), 120);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(255.0, 0.6);
  vtkSmartPointer<vtkVolumeProperty> matter = gallery::MakeColouredMatter(opacity, 1.0);
  matter->SetAmbient(0.15);
  matter->SetDiffuse(0.95);
  matter->SetSpecular(0.0);
  gallery::Panel& panel = stage.AddPanel("", { 0.25, -1.0, 0.5 });
  // All of this scatters evenly, at its edges too.
  panel.Add(gallery::MakeSlicedVolume(image, matter, 1.0));
  gallery::AddModel(panel,
    interlume::Move(interlume::MakeTeapot(), { { 0.0, 0.0, 0.005 } }, { { 0.0, 0.0, 12.0 } }));
  gallery::AddGround(panel, { { 0.0, 0.0, -0.02 } }, 1.5);
  gallery::UseSceneShadows(panel);
  panel.SetLights({ gallery::MakePointLight({ -2.2, -0.9, 4.0 }, 1.0),
    gallery::MakeFillLight({ 1.0, -1.0, 0.5 }, 0.25) });
  panel.Frame(vtkBoundingBox(-1.3, 1.3, -0.1, 0.1, -0.82, 1.4));
}

const gallery::SceneRegistration registration(
  { "teapot-cube", "2.45", "A teapot within a translucent cube",
    "The teapot is of polygons, what surrounds it a volume. The shadow of the spout and of the "
    "handle "
    "falls on the pot, and the shadow of all goes on through the translucent matter to the ground.",
    {}, &Build });
}

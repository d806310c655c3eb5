// SPDX-License-Identifier: BSD-3-Clause
// Polygonal mushrooms and their shadows.

#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/LightScreens.h"
#include "Gallery/Scenes/Light/SoftShadows.h"
#include "Gallery/Scenes/Mixed/ModelActors.h"
#include "Gallery/Stage.h"

namespace
{
using namespace interlume;

Model MakeMushrooms()
{
  Model all =
    Move(MakeMushroom(1.0, 0.48, 0.06), { { -0.12, 0.12, 0.0 } }, { { 0.0, 0.0, 200.0 } });
  Append(
    all, Move(MakeMushroom(0.64, 0.36, 0.18), { { 0.52, -0.16, 0.0 } }, { { 0.0, 0.0, -20.0 } }));
  return Append(
    all, Move(MakeMushroom(0.4, 0.2, 0.2), { { -0.5, -0.42, 0.0 } }, { { 0.0, 0.0, 215.0 } }));
}

void AddMushrooms(gallery::Panel& panel)
{
  gallery::AddModel(panel, MakeMushrooms());
  gallery::AddGround(panel, { { 0.0, 0.0, 0.0 } }, 1.2);
  panel.LookFrom({ 0.1, -1.0, 0.5 }, { 0.0, 0.0, 1.0 });
}

gallery::Lights MakeLights()
{
  return { gallery::MakePointLight({ -2.4, -2.0, 3.8 }, 0.95),
    gallery::MakeFillLight({ 1.0, -1.0, 0.5 }, 0.35) };
}

void Build(gallery::Stage& stage)
{
  gallery::Panel& panel = stage.AddPanel("");
  AddMushrooms(panel);
  gallery::UseSceneShadows(panel);
  panel.Frame(vtkBoundingBox(-1.12, 1.12, -0.1, 0.1, -0.8, 1.0));
  panel.SetLights(MakeLights());
}

void BuildSoft(gallery::Stage& stage)
{
  for (const bool isSoft : { false, true })
  {
    gallery::Panel& panel = stage.AddPanel(isSoft ? "soft shadows" : "hard shadows");
    AddMushrooms(panel);
    gallery::UseSceneShadows(panel, 100);
    panel.Frame(vtkBoundingBox(-1.12, 1.12, -0.1, 0.1, -0.5, 0.9));
    panel.SetLights(isSoft ? gallery::MakeRoundLights(MakeLights(), 1.3) : MakeLights());
  }
}

const gallery::SceneRegistration registration({ "mushrooms", "2.43", "The shadows of mushrooms",
  "Three polygonal mushrooms on a plate. Caps shade their own stems and gills, the small mushrooms "
  "stand in the shadow of the large one, and all cast shadows on the plate.",
  {}, &Build });
const gallery::SceneRegistration softRegistration(
  { "mushrooms-soft", "2.48", "Hard and soft shadows of mushrooms",
    "The same mushrooms under a point light and under a disk light. The shadows of the stems are "
    "sharp at their feet. The shadows of the caps widen with their height above the plate and "
    "above other caps.",
    {}, &BuildSoft });
}

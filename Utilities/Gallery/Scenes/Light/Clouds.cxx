// SPDX-License-Identifier: BSD-3-Clause
// Clouds in the sun, by light that is scattered once and more often.

#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/CloudScene.h"
#include "Gallery/Stage.h"
#include "Support/Inputs/Clouds.h"

#include "vtkSpatialObject.h"

namespace
{
const std::vector<interlume::Cumulus> CLOUDS = {
  { { { -0.45, 0.1, 0.0 } }, 0.95, 0.7, 1.05, 11, 3 },
  { { { 1.05, 0.25, 0.02 } }, 0.62, 0.7, 0.55, 9, 8 },
  { { { 0.55, -0.55, 0.06 } }, 0.34, 0.7, 0.24, 7, 5 },
  { { { -1.55, 0.4, 0.1 } }, 0.36, 0.8, 0.24, 7, 12 },
};

void Build(gallery::Stage& stage, gallery::Scattering scattering, double exposure)
{
  gallery::Panel& panel = stage.AddPanel("", { 0.0, -1.0, 0.02 });
  panel.Add(gallery::MakeCloudVolume(
    interlume::MakeClouds(CLOUDS), { { -2.0, 1.9, -0.95, 1.05, -0.15, 1.35 } }, 240, scattering));
  gallery::UseSky(panel, { -0.6, 0.62, 0.75 }, exposure);
  panel.Frame(vtkBoundingBox(-1.6, 1.6, -0.1, 0.1, -0.2, 1.4));
}

void BuildSingle(gallery::Stage& stage)
{
  Build(stage, gallery::Scattering::SINGLE, 8.0);
}

void BuildForward(gallery::Stage& stage)
{
  Build(stage, gallery::Scattering::FORWARD, 3.0);
}

void BuildFull(gallery::Stage& stage)
{
  Build(stage, gallery::Scattering::FULL, 1.0);
}

const gallery::SceneRegistration singleRegistration(
  { "clouds-single", "2.50", "Clouds by light that is scattered once",
    "Cumulus clouds in the sun, which stands behind them on the left. Light is scattered once "
    "before it is seen: edges that it has come through are bright, and all else is dark. "
    "The lights are eight times as bright as for clouds-full.",
    {}, &BuildSingle });

const gallery::SceneRegistration forwardRegistration(
  { "clouds-forward", "2.52", "Clouds by light that is scattered forwards",
    "The same clouds. Light goes on and on, away from the sun: the clouds are brighter, and light "
    "comes through where they are thin. The lights are three times as bright as for clouds-full.",
    {}, &BuildForward });

const gallery::SceneRegistration fullRegistration(
  { "clouds-full", "2.53", "Clouds by light that is scattered forwards and back",
    "The same clouds. Light goes to and fro until it leaves: the clouds are white "
    "towards the sun and soft inside.",
    {}, &BuildFull });
}

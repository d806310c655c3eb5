// SPDX-License-Identifier: BSD-3-Clause
// Sunlit clouds with single, forward and full multiple scattering.

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

void Build(gallery::Stage& stage, gallery::Scattering scattering)
{
  gallery::Panel& panel = stage.AddPanel("", { 0.0, -1.0, 0.02 });
  panel.Add(gallery::MakeCloudVolume(
    interlume::MakeClouds(CLOUDS), { { -2.0, 1.9, -0.95, 1.05, -0.15, 1.35 } }, 340, scattering));
  // With full scattering, much more light reaches the camera.
  const double exposure = scattering == gallery::Scattering::FULL ? 1.0 : 2.0;
  gallery::UseSky(panel, { -0.4, 0.9, 0.38 }, { 0.05, -0.8, 1.0 }, 0.22 * exposure, 0.3 * exposure);
  panel.Frame(vtkBoundingBox(-1.7, 1.55, -0.1, 0.1, -0.36, 1.5));
}

void BuildSingle(gallery::Stage& stage)
{
  Build(stage, gallery::Scattering::SINGLE);
}

void BuildForward(gallery::Stage& stage)
{
  Build(stage, gallery::Scattering::FORWARD);
}

void BuildFull(gallery::Stage& stage)
{
  Build(stage, gallery::Scattering::FULL);
}

const gallery::SceneRegistration singleRegistration(
  { "clouds-single", "2.50", "Clouds with single scattering",
    "Cumulus clouds, with the sun behind them on the left. Only single scattering: edges through "
    "which light passes are bright, all other parts are dark. The lights are those of "
    "clouds-full, the exposure is twice as high.",
    {}, &BuildSingle });

const gallery::SceneRegistration forwardRegistration(
  { "clouds-forward", "2.52", "Clouds with forward scattering",
    "The same clouds with forward multiple scattering, with the lights and the exposure of "
    "clouds-single. They are brighter, and light passes through thin parts.",
    {}, &BuildForward });

const gallery::SceneRegistration fullRegistration(
  { "clouds-full", "2.53", "Clouds with full multiple scattering",
    "The same clouds with full multiple scattering: they are white on the sunlit side and soft "
    "inside.",
    {}, &BuildFull });
}

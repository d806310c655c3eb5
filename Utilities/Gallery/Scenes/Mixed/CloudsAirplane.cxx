// SPDX-License-Identifier: BSD-3-Clause
// A polygonal airplane above clouds.

#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/CloudScene.h"
#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Gallery/Scenes/Mixed/ModelActors.h"
#include "Gallery/Stage.h"
#include "Support/Inputs/Clouds.h"

namespace
{
void Build(gallery::Stage& stage)
{
  const std::vector<interlume::Cumulus> clouds = {
    { { { -1.0, 0.35, 0.0 } }, 0.85, 0.8, 0.62, 11, 4 },
    { { { 0.65, 0.8, 0.0 } }, 0.85, 0.7, 0.5, 11, 7 },
    { { { 0.4, -0.5, 0.0 } }, 0.75, 0.8, 0.34, 10, 2 },
    { { { 1.65, -0.1, 0.0 } }, 0.6, 0.8, 0.42, 9, 11 },
    { { { -0.75, -0.85, 0.0 } }, 0.6, 0.8, 0.26, 9, 13 },
    { { { -1.95, -0.3, 0.0 } }, 0.55, 0.8, 0.3, 8, 17 },
    { { { 1.3, -0.95, 0.0 } }, 0.5, 0.8, 0.22, 8, 19 },
  };
  gallery::Panel& panel = stage.AddPanel("", { 0.12, -1.0, 0.62 });
  vtkSmartPointer<vtkVolume> volume = gallery::MakeCloudVolume(interlume::MakeClouds(clouds),
    { { -2.6, 2.4, -1.6, 1.7, -0.12, 0.95 } }, 260, gallery::Scattering::FULL);
  // The clouds are small. They are white up to their edges because their droplets scatter less
  // light forward than real droplets.
  gallery::Scatter(volume, gallery::Scattering::FULL, 0.5);
  panel.Add(volume);
  gallery::AddModel(panel,
    interlume::Move(
      interlume::MakeAirplane(), { { -0.15, -0.55, 0.92 } }, { { 24.0, -5.0, -22.0 } }),
    0.8, 0.5);
  gallery::UseSceneShadows(panel);
  gallery::UseSky(panel, { -0.6, -0.25, 0.85 }, 0.75);
  panel.Frame(vtkBoundingBox(-1.5, 1.5, -0.5, 0.5, -0.12, 1.0));
}

const gallery::SceneRegistration registration(
  { "clouds-airplane", "2.54", "An airplane above clouds",
    "The airplane consists of polygons, the clouds are a volume with full multiple scattering. The "
    "airplane casts its shadow on the clouds.",
    {}, &Build });
}

// SPDX-License-Identifier: BSD-3-Clause
// Three beams of light through a translucent cube.

#include "Gallery/Panel.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/LightScreens.h"
#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Gallery/Scenes/Light/TranslucentBox.h"
#include "Gallery/Stage.h"
#include "Gallery/VectorArithmetic.h"

#include "vtkLight.h"
#include "vtkProjectiveLight.h"

#include <array>

namespace
{
void Build(gallery::Stage& stage)
{
  const std::array<vtkColor3d, 3> colours = { { { 1.0, 0.16, 0.10 }, { 0.16, 1.0, 0.22 },
    { 0.16, 0.32, 1.0 } } };
  gallery::Lights beams;
  double height = 0.24;
  for (const vtkColor3d& colour : colours)
  {
    const vtkVector3d centre(0.0, 0.0, height);
    beams.push_back(
      gallery::MakeBeam(centre + vtkVector3d(1.6, -0.2, 0.75), centre, 0.2, 6.5, colour));
    height -= 0.24;
  }
  const gallery::TranslucentBox cube = { { 0.84, 0.84, 0.84 }, 25.0, 1.8, 0.35 };
  gallery::AddTranslucentBox(stage, cube, beams)
    .Look({ 0.1, -1.0, 0.25 }, vtkBoundingBox(-0.74, 0.74, -0.3, 0.3, -0.6, 0.6));
}

const gallery::SceneRegistration registration(
  { "beams-cube", "2.24", "Red, green and blue beams through a translucent cube",
    "Parallel beams come in at the upper right, pass a translucent cube and leave it at the lower "
    "left, in air thin enough to show them. Without attenuation they leave as bright as they came; "
    "with it the cube takes most of their light. In both what is in front hides a part of them.",
    {}, &Build });
}

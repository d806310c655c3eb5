// SPDX-License-Identifier: BSD-3-Clause
// A beam of light through a translucent box.

#include "Gallery/Panel.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/LightScreens.h"
#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Gallery/Scenes/Light/TranslucentBox.h"
#include "Gallery/Stage.h"

#include "vtkLight.h"
#include "vtkProjectiveLight.h"

namespace
{
void Build(gallery::Stage& stage)
{
  const gallery::TranslucentBox box = { { 1.0, 0.6, 0.7 }, 35.0, 2.2, 0.4 };
  gallery::AddTranslucentBox(stage, box,
    { gallery::MakeBeam({ -3.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, 0.26, 4.4, { 1.0, 0.86, 0.6 }) })
    .Look({ 0.0, -1.0, 0.35 }, vtkBoundingBox(-0.74, 0.74, -0.3, 0.3, -0.6, 0.6));
}

const gallery::SceneRegistration registration(
  { "beam-box", "2.25", "A beam of light through a box turned by 35 degrees",
    "The beam goes from left to right, perpendicular to the view. Without attenuation it is "
    "brightest "
    "at the right, where less of the translucent box lies in front of it; with attenuation most of "
    "its light is lost in the box, and only a little leaves.",
    {}, &Build });
}

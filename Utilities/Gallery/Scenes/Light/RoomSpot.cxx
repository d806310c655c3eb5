// SPDX-License-Identifier: BSD-3-Clause
// A spotlight in a room with thin smoke.

#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/HazyRoom.h"
#include "Gallery/Scenes/Light/LightScreens.h"

namespace
{
void Build(gallery::Stage& stage)
{
  vtkSmartPointer<vtkProjectiveLight> spot = gallery::MakeProjector(
    { -1.2, -1.5, 2.7 }, { 0.0, 0.15, 0.3 }, 1.4, 1.4, 3.2, gallery::MakeSoftDiskImage(0.12));
  spot->SetDiffuseColor(1.0, 0.93, 0.80);
  gallery::AddHazyRoom(stage, 0.0036, { spot, gallery::MakeFillLight({ 0.5, -1.0, 0.6 }, 0.25) });
}

const gallery::SceneRegistration registration({ "room-spot", "2.22", "A spot of light in a room",
  "A robot and rings in a room with thin smoke, a constructive volume, under a light whose screen "
  "has a disk with a soft edge. The light beam and the shadows of the robot and the rings are "
  "visible in the smoke.",
  {}, &Build });
}

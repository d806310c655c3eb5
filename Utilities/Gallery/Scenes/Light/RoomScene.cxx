// SPDX-License-Identifier: BSD-3-Clause
// A robot, rings and smoke in a room.

#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/Room.h"
#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Gallery/Stage.h"

namespace
{
void Build(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = gallery::SampleFurnishedRoom(190);
  gallery::Panel& panel =
    gallery::AddShadowPanel(stage, image, gallery::MakeSolidMediumInSmoke(image, 0.09),
      gallery::MakeStudioLights({ 2.8, -1.8, 2.8 }), gallery::SMOKE_GRADIENT);
  gallery::UseBackdrop(panel, { 0.24, 0.25, 0.28 }, { 0.40, 0.43, 0.48 });
  panel.LookFrom({ 0.6, -1.0, 0.45 }, { 0.0, 0.0, 1.0 });
  panel.Frame(vtkBoundingBox(-1.0, 1.0, -1.0, 1.0, 0.02, 1.28));
}

const gallery::SceneRegistration registration({ "room", "2.9", "A room with hard and soft shadows",
  "A robot, rings and a cloud of smoke in a room. The solid objects cast shadows with sharp edges "
  "on the floor and the walls. The shadow of the smoke fades out at its border.",
  {}, &Build });
}

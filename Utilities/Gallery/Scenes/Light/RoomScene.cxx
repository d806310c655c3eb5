// SPDX-License-Identifier: BSD-3-Clause
// A robot, rings and smoke in a room.

#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/Room.h"
#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Gallery/Stage.h"

#include "vtkShadowedSliceMapper.h"

namespace
{
void Build(gallery::Stage& stage)
{
  vtkSmartPointer<vtkImageData> image = gallery::SampleFurnishedRoom(320);
  vtkSmartPointer<vtkVolume> volume = gallery::MakeSlicedVolume(
    image, gallery::MakeSolidMediumInSmoke(image, 0.054), gallery::SMOKE_GRADIENT);
  // With the defaults, the image would be less sharp than the volume, and a weave would be visible.
  vtkShadowedSliceMapper* mapper = gallery::GetSlicedMapper(volume);
  mapper->SetImageSampleDistance(1.5);
  mapper->SetSliceSpacing(0.35 * image->GetSpacing()[0]);
  mapper->SetLightBufferSize(1024);
  gallery::Panel& panel = stage.AddPanel("");
  panel.Add(volume);
  panel.SetLights(gallery::MakeStudioLights({ 3.0, -2.3, 2.7 }, 1.1));
  panel.SetBackground({ 0.24, 0.25, 0.28 }, { 0.40, 0.43, 0.48 });
  panel.LookFrom({ 0.6, -1.0, 0.45 }, { 0.0, 0.0, 1.0 });
  panel.Frame(vtkBoundingBox(-1.0, 1.0, -1.0, 1.0, -0.05, 1.28));
}

const gallery::SceneRegistration registration({ "room", "2.9", "A room with hard and soft shadows",
  "A robot, rings and a cloud of smoke in a room. The solid objects cast shadows with sharp edges "
  "on the floor and the walls. The shadow of the smoke fades out at its border.",
  {}, &Build });
}

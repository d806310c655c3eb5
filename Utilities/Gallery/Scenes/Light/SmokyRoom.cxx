// SPDX-License-Identifier: BSD-3-Clause
// A room with smoke that is denser at the floor, and a cube inside.

#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/Room.h"
#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Gallery/Stage.h"

#include "vtkNew.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkTurbulenceSource.h"

namespace
{
void Build(gallery::Stage& stage)
{
  // Faces at an angle to the sampling grid would have streaks.
  vtkSmartPointer<vtkSpatialObject> all =
    gallery::Unite({ gallery::MakeBox({ 0.1, -0.2, 0.02 }, { 0.7, 0.4, 0.6 }, { 0.80, 0.47, 0.26 }),
      gallery::MakeRoom(vtkBoundingBox(-1.0, 1.5, -1.0, 1.0, 0.0, 1.5)) });
  vtkSmartPointer<vtkImageData> image =
    gallery::Sample(all, vtkBoundingBox(-1.1, 1.5, -1.0, 1.1, -0.1, 1.5), 260, 1.4);
  vtkNew<vtkTurbulenceSource> smoke;
  smoke->SetFrequency(1.9);
  smoke->SetOffset(-0.06);
  smoke->SetAmplitude(1.4);
  smoke->SetFalloff(vtkTurbulenceSource::EXPONENTIAL);
  smoke->SetTopFraction(0.006);
  gallery::AddSmoke(image, smoke, 0.52, { 0.86, 0.87, 0.88 });
  gallery::AddSmoke(image, gallery::MakePuff({ -0.35, -0.45, 0.5 }), 0.3, { 0.86, 0.87, 0.88 });
  vtkSmartPointer<vtkVolume> volume = gallery::MakeSlicedVolume(
    image, gallery::MakeSolidMediumInSmoke(image, 0.035), gallery::SMOKE_GRADIENT);
  // With the defaults, a weave would be visible on the walls and the cube.
  gallery::GetSlicedMapper(volume)->SetSliceSpacing(0.3 * image->GetSpacing()[0]);
  gallery::GetSlicedMapper(volume)->SetLightBufferSize(1024);
  gallery::Panel& panel = stage.AddPanel("");
  panel.Add(volume);
  panel.SetLights(gallery::MakeStudioLights({ 2.9, -2.4, 2.8 }));
  panel.SetBackground({ 0.20, 0.22, 0.26 }, { 0.34, 0.38, 0.44 });
  panel.LookFrom({ 0.5, -1.0, 0.38 }, { 0.0, 0.0, 1.0 });
  panel.Frame(vtkBoundingBox(-0.9, 0.8, -0.22, 1.0, 0.06, 1.0));
}

const gallery::SceneRegistration registration({ "smoky-room", "2.8", "A cube in a smoky room",
  "Smoke fills a room, dense at the floor and thin above, with turbulence, and rises in a cloud. "
  "It attenuates the light, receives the shadow of the cube and casts a shadow itself.",
  {}, &Build });
}

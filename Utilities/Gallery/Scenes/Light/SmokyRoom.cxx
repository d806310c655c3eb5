// SPDX-License-Identifier: BSD-3-Clause
// A room with smoke that is denser at the floor, and a cube inside.

#include "Gallery/Scene.h"
#include "Gallery/Scenes/Light/Room.h"
#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Gallery/Stage.h"

#include "vtkNew.h"
#include "vtkTurbulenceSource.h"

namespace
{
void Build(gallery::Stage& stage)
{
  vtkSmartPointer<vtkSpatialObject> all = gallery::Unite(
    { gallery::Place(gallery::MakeBox({ -0.3, -0.3, 0.0 }, { 0.3, 0.3, 0.6 }, { 0.80, 0.47, 0.26 }),
        { 0.0, 0.15, 0.0 }, 30.0),
      gallery::MakeRoom() });
  vtkSmartPointer<vtkImageData> image =
    gallery::Sample(all, vtkBoundingBox(-1.1, 1.1, -1.1, 1.1, -0.1, 1.4), 160);
  vtkNew<vtkTurbulenceSource> smoke;
  smoke->SetFrequency(1.9);
  smoke->SetOffset(-0.06);
  smoke->SetAmplitude(1.4);
  smoke->SetFalloff(vtkTurbulenceSource::EXPONENTIAL);
  smoke->SetTopFraction(0.002);
  gallery::AddSmoke(
    image, smoke, 0.42, { 0.86, 0.87, 0.88 }, vtkBoundingBox(-1.0, 0.98, -0.98, 1.0, 0.0, 1.3));
  gallery::Panel& panel =
    gallery::AddShadowPanel(stage, image, gallery::MakeSolidMediumInSmoke(image, 0.045),
      gallery::MakeStudioLights({ 2.8, -1.6, 3.2 }, 1.0), gallery::SMOKE_GRADIENT);
  gallery::UseBackdrop(panel, { 0.20, 0.22, 0.26 }, { 0.34, 0.38, 0.44 });
  panel.LookFrom({ 0.6, -1.0, 0.45 }, { 0.0, 0.0, 1.0 });
  panel.Frame(vtkBoundingBox(-1.0, 1.0, -1.0, 1.0, 0.02, 1.28));
}

const gallery::SceneRegistration registration({ "smoky-room", "2.8", "A cube in a smoky room",
  "Smoke fills a room, dense at the floor and thin above, with turbulence. It attenuates the "
  "light, receives the shadow of the cube and casts a shadow itself.",
  {}, &Build });
}

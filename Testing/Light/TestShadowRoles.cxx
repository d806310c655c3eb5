// SPDX-License-Identifier: BSD-3-Clause
// Actors that are kept from casting or from receiving shadows by vtkShadowedScenePass: what they
// shadow and show, opaque and translucent, beside smoke and as parts of an assembly.
#include "Support/Checks/ReferenceCheck.h"
#include "SceneStage.h"

#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkProjectiveLight.h"
#include "vtkRenderer.h"
#include "vtkShadowedSliceMapper.h"

#include <array>
#include <cmath>
#include <string>

namespace
{
using namespace reference;
using Pass = vtkShadowedScenePass;

constexpr double LIT = 0.9;
constexpr double DARK = 0.05;
const std::array<double, 3> DOWN{ { -0.6, 0.0, -1.0 } };

vtkSmartPointer<vtkActor> MakeFloor()
{
  return MakeRectangle({ { -3.0, -3.0, -0.5 } }, { { 6.0, 0.0, 0.0 } }, { { 0.0, 6.0, 0.0 } });
}

// A stage with a floor and a plate over it whose shadow lies to the left of it: the plate shows at
// (0.4, 0), its shadow at (-0.3, 0).
struct Plates
{
  Plates()
    : Stage(64)
    , Floor(MakeFloor())
    , Plate(MakeRectangle({ { 0.1, -0.3, 0.5 } }, { { 0.6, 0.0, 0.0 } }, { { 0.0, 0.6, 0.0 } }))
  {
    this->Stage.Add(this->Floor);
    this->Stage.Add(this->Plate);
    this->Stage.Stage.SetLights({ MakeSun({ { -0.7, 0.0, -1.0 } }) });
  }

  SceneStage Stage;
  vtkSmartPointer<vtkActor> Floor;
  vtkSmartPointer<vtkActor> Plate;
  const double Sun = 1.0 / std::sqrt(1.49);
};

void TestKeys(Check& check)
{
  const vtkSmartPointer<vtkActor> actor = MakeFloor();
  check.That(Pass::GetCastsShadows(actor) && Pass::GetReceivesShadows(actor), "on without keys");
  Pass::SetCastsShadows(actor, true);
  check.That(!actor->GetPropertyKeys(), "no keys for what is on");
  Pass::SetCastsShadows(actor, false);
  check.That(!Pass::GetCastsShadows(actor) && Pass::GetReceivesShadows(actor), "casts none");
  actor->GetPropertyKeys()->Set(Pass::RECEIVES_SHADOWS(), 0);
  check.That(!Pass::GetReceivesShadows(actor), "receives none by its key");
  Pass::SetReceivesShadows(actor, true);
  Pass::SetCastsShadows(actor, true);
  check.That(!actor->GetPropertyKeys()->Has(Pass::CASTS_SHADOWS()) &&
      !actor->GetPropertyKeys()->Has(Pass::RECEIVES_SHADOWS()),
    "keys are removed");
  Pass::SetCastsShadows(nullptr, false);
  check.That(!Pass::GetCastsShadows(nullptr), "no prop");
}

void TestSurfaces(Check& check)
{
  Plates scene;
  const auto at = [&](const std::string& name, double shadow, int casters)
  {
    const RgbaPicture picture = scene.Stage.Draw();
    check.Near(scene.Stage.At(picture, -0.3, 0.0), shadow, 1e-3, name + ": floor", 1.0);
    check.Near(scene.Stage.At(picture, 0.4, 0.0), scene.Sun, 1e-3, name + ": plate", 1.0);
    check.Near(
      scene.Stage.GetReport()->GetNumber("ShadowCasters"), casters, 0.0, name + ": casters");
    return picture;
  };
  const RgbaPicture first = at("both", 0.0, 2);
  Pass::SetCastsShadows(scene.Plate, false);
  at("plate casts none", scene.Sun, 1);
  check.Near(scene.Stage.GetReport()->GetNumber("NonCastingActors"), 1, 0.0, "one casts none");
  Pass::SetCastsShadows(scene.Floor, false);
  const RgbaPicture none = at("none casts", scene.Sun, 0);
  check.Near(scene.Stage.GetReport()->GetNumber("NonCastingActors"), 2, 0.0, "none casts");
  check.Near(scene.Stage.GetReport()->GetNumber("DepthMaps"), 0, 0.0, "no map without casters");
  check.Near(
    scene.Stage.GetReport()->GetNumber("DepthMapBytes"), 0, 0.0, "no byte without casters");
  check.Near(ComparePictures(none, scene.Stage.Draw(false)).Max, 0.0, 0.0, "as without pass", 1.0);
  Pass::SetCastsShadows(scene.Floor, true);
  Pass::SetCastsShadows(scene.Plate, true);
  Pass::SetReceivesShadows(scene.Floor, false);
  at("floor receives none", scene.Sun, 2);
  check.Near(scene.Stage.GetReport()->GetNumber("NonReceivingActors"), 1, 0.0, "one receives none");
  Pass::SetReceivesShadows(scene.Floor, true);
  check.Near(
    ComparePictures(first, at("both again", 0.0, 2)).Max, 0.0, 0.0, "as at the first", 1.0);
}

// What receives no shadows has the image of a light, and light behind a screen is none.
void TestScreens(Check& check)
{
  Plates scene;
  vtkNew<vtkProjectiveLight> light;
  light->SetPosition(0.0, 0.0, 3.0);
  light->SetFocalPoint(0.0, 0.0, 1.5);
  light->SetPositional(true);
  light->SetConeAngle(180.0);
  light->SetScreenSize(1.0, 1.0);
  light->SetScreenOpacity(0.25);
  scene.Stage.Stage.SetLights({ light.Get() });
  Pass::SetCastsShadows(scene.Plate, false);
  const RgbaPicture open = scene.Stage.Draw();
  Pass::SetCastsShadows(scene.Plate, true);
  Pass::SetReceivesShadows(scene.Floor, false);
  Pass::SetReceivesShadows(scene.Plate, false);
  const RgbaPicture lit = scene.Stage.Draw();
  check.Near(scene.Stage.GetReport()->GetNumber("Images"), 1, 0.0, "a screen");
  check.Near(ComparePictures(open, lit).Max, 0.0, 1e-6, "screens without shadows", 1.0);
  check.That(ComparePictures(lit, scene.Stage.Draw(false)).Max > 0.1, "the screen is there");
}

// Smoke over a floor: who casts none is not in the smoke's light, who receives none has all of it.
void TestSmoke(Check& check)
{
  const double sun = 1.0 / std::sqrt(1.0 + 0.36);
  SceneStage stage(64);
  const vtkSmartPointer<vtkActor> floor = MakeFloor();
  const vtkSmartPointer<vtkActor> plate =
    MakeRectangle({ { 0.5, -0.4, 0.8 } }, { { 0.4, 0.0, 0.0 } }, { { 0.0, 0.8, 0.0 } });
  stage.Add(floor);
  stage.AddSmoke({ { -0.4, 0.4, -0.4, 0.4, 0.0, 0.3 } }, 2.0);
  stage.Stage.SetLights({ MakeSun(DOWN) });
  const RgbaPicture alone = stage.Draw();
  stage.Add(plate);
  const RgbaPicture shadowed = stage.Draw();
  Pass::SetCastsShadows(plate, false);
  const RgbaPicture without = stage.Draw();
  // The plate's shadow crosses the smoke between x = -0.1 and 0.4.
  for (const double x : { -0.2, 0.0, 0.2 })
  {
    check.Near(stage.At(without, x, 0.0), stage.At(alone, x, 0.0), 1e-5, "smoke as alone", 1.0);
  }
  check.That(
    stage.At(shadowed, 0.2, 0.0) < 0.8 * stage.At(alone, 0.2, 0.0), "the plate's shadow in smoke");
  // Light that has come through the smoke falls on the floor at the left of it.
  check.That(stage.At(without, -0.6, 0.0) < LIT * sun, "the smoke's shadow");
  Pass::SetReceivesShadows(floor, false);
  const RgbaPicture open = stage.Draw();
  check.Near(stage.At(open, -0.6, 0.0), sun, 1e-3, "no shadow of smoke", 1.0);
  // Light has come through the smoke that is seen before it.
  check.That(stage.At(open, -0.2, 0.0) > 1.05 * stage.At(without, -0.2, 0.0), "brighter in smoke");
}

// A pane takes half of the light, unless it casts none; it is seen in smoke as ever.
void TestPanes(Check& check)
{
  const double sun = 1.0 / std::sqrt(1.49);
  SceneStage stage(64);
  const vtkSmartPointer<vtkActor> pane =
    MakePane({ { 0.4, 0.0, 0.5 } }, { { 0.0, 0.0, 1.0 } }, 0.6);
  stage.Add(MakeFloor());
  stage.Add(pane);
  stage.Stage.SetLights({ MakeSun({ { -0.7, 0.0, -1.0 } }) });
  check.Near(stage.At(stage.Draw(), -0.3, 0.0), 0.5 * sun, 2e-3, "behind a pane", 1.0);
  Pass::SetCastsShadows(pane, false);
  check.Near(stage.At(stage.Draw(), -0.3, 0.0), sun, 1e-3, "behind one that casts none", 1.0);
  check.Near(stage.GetReport()->GetNumber("LightLayers"), 0, 0.0, "no layers for lights");
  check.Near(stage.GetReport()->GetNumber("TranslucentActors"), 1, 0.0, "it takes part");
  stage.AddSmoke({ { -0.4, 0.9, -0.4, 0.4, 0.3, 0.7 } }, 1.0);
  const RgbaPicture mixed = stage.Draw();
  check.Near(stage.GetReport()->GetNumber("CameraLayers"), 1, 0.0, "a layer for the eye");
  Pass::SetCastsShadows(pane, true);
  check.That(ComparePictures(mixed, stage.Draw()).Max > 0.01, "its shadow in smoke");
}

// Parts of an assembly go by its keys.
void TestAssembly(Check& check)
{
  const double sun = 1.0 / std::sqrt(1.49);
  SceneStage stage(64);
  vtkNew<vtkAssembly> parts;
  parts->AddPart(
    MakeRectangle({ { 0.1, -0.3, 0.5 } }, { { 0.6, 0.0, 0.0 } }, { { 0.0, 0.6, 0.0 } }));
  parts->AddPart(MakeFloor());
  stage.Stage.GetRenderer()->AddViewProp(parts);
  stage.Stage.SetLights({ MakeSun({ { -0.7, 0.0, -1.0 } }) });
  check.Near(stage.At(stage.Draw(), -0.3, 0.0), 0.0, DARK, "within an assembly", 1.0);
  Pass::SetReceivesShadows(parts, false);
  check.Near(stage.At(stage.Draw(), -0.3, 0.0), sun, 1e-3, "its parts receive none", 1.0);
  Pass::SetReceivesShadows(parts, true);
  Pass::SetCastsShadows(parts, false);
  stage.Add(MakeFloor());
  check.Near(stage.At(stage.Draw(), -0.3, 0.0), sun, 1e-3, "its parts cast none", 1.0);
}

}

int TestShadowRoles(int, char*[])
{
  Check check;
  TestKeys(check);
  TestSurfaces(check);
  TestScreens(check);
  TestSmoke(check);
  TestPanes(check);
  TestAssembly(check);
  return check.Result();
}

// SPDX-License-Identifier: BSD-3-Clause
// Actors that vtkShadowedScenePass excludes from casting or receiving shadows, and invisible actors
// that cast shadows: opaque and translucent actors, actors with smoke, and parts of assemblies.
#include "Support/Checks/ReferenceCheck.h"
#include "SceneStage.h"

#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkProjectiveLight.h"
#include "vtkProperty.h"
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

// A plate above a floor. The plate is visible at (0.4, 0), and its shadow at (-0.3, 0).
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
  check.That(Pass::GetCastsShadows(actor) && Pass::GetReceivesShadows(actor),
    "casting and receiving are on without keys");
  Pass::SetCastsShadows(actor, true);
  check.That(!actor->GetPropertyKeys(), "the default adds no keys");
  Pass::SetCastsShadows(actor, false);
  check.That(!Pass::GetCastsShadows(actor) && Pass::GetReceivesShadows(actor), "casting is off");
  actor->GetPropertyKeys()->Set(Pass::RECEIVES_SHADOWS(), 0);
  check.That(!Pass::GetReceivesShadows(actor), "receiving is off by its key");
  Pass::SetReceivesShadows(actor, true);
  Pass::SetCastsShadows(actor, true);
  check.That(!actor->GetPropertyKeys()->Has(Pass::CASTS_SHADOWS()) &&
      !actor->GetPropertyKeys()->Has(Pass::RECEIVES_SHADOWS()),
    "the default removes the keys");
  Pass::SetCastsShadows(nullptr, false);
  check.That(!Pass::GetCastsShadows(nullptr), "a null prop casts no shadows");
  check.That(
    !Pass::GetCastsShadowsWhenInvisible(actor), "invisible props cast no shadows by default");
  Pass::SetCastsShadowsWhenInvisible(actor, true);
  check.That(Pass::GetCastsShadowsWhenInvisible(actor), "casting when invisible is on");
  Pass::SetCastsShadowsWhenInvisible(actor, false);
  check.That(!actor->GetPropertyKeys()->Has(Pass::CASTS_SHADOWS_WHEN_INVISIBLE()),
    "the default removes the key of invisible props");
  Pass::SetCastsShadowsWhenInvisible(nullptr, true);
  check.That(!Pass::GetCastsShadowsWhenInvisible(nullptr), "a null prop casts no shadows");
}

void TestSurfaces(Check& check)
{
  Plates scene;
  const auto at = [&](const std::string& name, double shadow, int casters)
  {
    const RgbaImage image = scene.Stage.Draw();
    check.Near(scene.Stage.At(image, -0.3, 0.0), shadow, 1e-3, name + ": floor", 1.0);
    check.Near(scene.Stage.At(image, 0.4, 0.0), scene.Sun, 1e-3, name + ": plate", 1.0);
    check.Equal(
      scene.Stage.GetReport()->GetCount("ShadowCasters"), casters, name + ": shadow casters");
    return image;
  };
  const RgbaImage first = at("both cast shadows", 0.0, 2);
  Pass::SetCastsShadows(scene.Plate, false);
  at("the plate casts no shadow", scene.Sun, 1);
  check.Equal(
    scene.Stage.GetReport()->GetCount("NonCastingActors"), 1, "one actor casts no shadow");
  Pass::SetCastsShadows(scene.Floor, false);
  const RgbaImage none = at("no actor casts shadows", scene.Sun, 0);
  check.Equal(scene.Stage.GetReport()->GetCount("NonCastingActors"), 2, "no actor casts shadows");
  check.Equal(
    scene.Stage.GetReport()->GetCount("DepthMaps"), 0, "no shadow maps without shadow casters");
  check.Equal(
    scene.Stage.GetReport()->GetCount("DepthMapBytes"), 0, "no bytes without shadow casters");
  check.Near(CompareImages(none, scene.Stage.Draw(false)).Max, 0.0, 0.0,
    "same image as without the pass", 1.0);
  Pass::SetCastsShadows(scene.Floor, true);
  Pass::SetCastsShadows(scene.Plate, true);
  Pass::SetReceivesShadows(scene.Floor, false);
  at("the floor receives no shadows", scene.Sun, 2);
  check.Equal(
    scene.Stage.GetReport()->GetCount("NonReceivingActors"), 1, "one actor receives no shadows");
  Pass::SetReceivesShadows(scene.Floor, true);
  check.Near(
    CompareImages(first, at("both again", 0.0, 2)).Max, 0.0, 0.0, "same image as at first", 1.0);
}

// Actors that receive no shadows still show the image that a light projects, and are black outside
// the image.
void TestLightImages(Check& check)
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
  const RgbaImage open = scene.Stage.Draw();
  Pass::SetCastsShadows(scene.Plate, true);
  Pass::SetReceivesShadows(scene.Floor, false);
  Pass::SetReceivesShadows(scene.Plate, false);
  const RgbaImage lit = scene.Stage.Draw();
  check.Equal(scene.Stage.GetReport()->GetCount("Images"), 1, "one light image");
  check.Near(CompareImages(open, lit).Max, 0.0, 1e-6, "light images without shadows", 1.0);
  check.That(CompareImages(lit, scene.Stage.Draw(false)).Max > 0.1, "the light image is visible");
}

// Smoke above a floor: an actor that casts no shadow does not darken the smoke, and an actor that
// receives no shadows is fully lit.
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
  const RgbaImage single = stage.Draw();
  stage.Add(plate);
  const RgbaImage shadowed = stage.Draw();
  Pass::SetCastsShadows(plate, false);
  const RgbaImage without = stage.Draw();
  // Inside the smoke, the plate's shadow extends from x = 0.02 to 0.4.
  for (const double x : { -0.2, 0.0, 0.2 })
  {
    check.Near(stage.At(without, x, 0.0), stage.At(single, x, 0.0), 1e-5,
      "smoke without the plate's shadow", 1.0);
  }
  check.That(stage.At(shadowed, 0.2, 0.0) < 0.8 * stage.At(single, 0.2, 0.0),
    "the plate's shadow in the smoke");
  // The smoke's shadow falls on the floor to the left of the smoke.
  check.That(stage.At(without, -0.6, 0.0) < LIT * sun, "the smoke's shadow");
  Pass::SetReceivesShadows(floor, false);
  const RgbaImage open = stage.Draw();
  check.Near(stage.At(open, -0.6, 0.0), sun, 1e-3, "no shadow of the smoke", 1.0);
  // The floor that is seen through the smoke is brighter, too.
  check.That(stage.At(open, -0.2, 0.0) > 1.05 * stage.At(without, -0.2, 0.0),
    "the floor behind the smoke is brighter");
}

// A translucent square halves the light, unless it casts no shadow. It remains visible in smoke.
void TestTranslucent(Check& check)
{
  const double sun = 1.0 / std::sqrt(1.49);
  SceneStage stage(64);
  const vtkSmartPointer<vtkActor> square =
    MakeTranslucentSquare({ { 0.4, 0.0, 0.5 } }, { { 0.0, 0.0, 1.0 } }, 0.6);
  stage.Add(MakeFloor());
  stage.Add(square);
  stage.Stage.SetLights({ MakeSun({ { -0.7, 0.0, -1.0 } }) });
  check.Near(
    stage.At(stage.Draw(), -0.3, 0.0), 0.5 * sun, 2e-3, "light behind a translucent square", 1.0);
  Pass::SetCastsShadows(square, false);
  check.Near(
    stage.At(stage.Draw(), -0.3, 0.0), sun, 1e-3, "light behind a square without shadow", 1.0);
  check.Equal(stage.GetReport()->GetCount("LightLayers"), 0, "no light layers");
  check.Equal(stage.GetReport()->GetCount("TranslucentActors"), 1,
    "the square is a translucent actor of the pass");
  stage.AddSmoke({ { -0.4, 0.9, -0.4, 0.4, 0.3, 0.7 } }, 1.0);
  const RgbaImage mixed = stage.Draw();
  check.Equal(stage.GetReport()->GetCount("CameraLayers"), 1, "one camera layer");
  Pass::SetCastsShadows(square, true);
  check.That(CompareImages(mixed, stage.Draw()).Max > 0.01, "the square's shadow in the smoke");
}

// An invisible plate can cast the same shadow as a visible one.
void TestInvisible(Check& check)
{
  Plates scene;
  const auto at = [&](const std::string& name, double plate, double shadow)
  {
    const RgbaImage image = scene.Stage.Draw();
    check.Near(scene.Stage.At(image, 0.4, 0.0), plate, 1e-3, name + ": at the plate", 1.0);
    check.Near(scene.Stage.At(image, -0.3, 0.0), shadow, 1e-3, name + ": in its shadow", 1.0);
  };
  at("visible", scene.Sun, 0.0);
  scene.Plate->VisibilityOff();
  // By default, an invisible plate casts no shadow.
  at("invisible", scene.Sun, scene.Sun);
  Pass::SetCastsShadowsWhenInvisible(scene.Plate, true);
  scene.Plate->GetProperty()->SetColor(0.2, 0.2, 0.2);
  at("invisible with shadow", scene.Sun, 0.0);
  Pass::SetCastsShadows(scene.Plate, false);
  at("invisible without shadow", scene.Sun, scene.Sun);
  Pass::SetCastsShadows(scene.Plate, true);
  scene.Plate->GetProperty()->SetOpacity(0.5);
  at("invisible and translucent", scene.Sun, 0.5 * scene.Sun);
}

// Smoke under an invisible plate, without any visible surface.
void TestInvisibleInSmoke(Check& check)
{
  SceneStage stage(64);
  const vtkSmartPointer<vtkActor> plate =
    MakeRectangle({ { 0.5, -0.4, 0.8 } }, { { 0.4, 0.0, 0.0 } }, { { 0.0, 0.8, 0.0 } });
  stage.AddSmoke({ { -0.4, 0.4, -0.4, 0.4, 0.0, 0.3 } }, 2.0);
  stage.Stage.SetLights({ MakeSun(DOWN) });
  const RgbaImage lit = stage.Draw();
  stage.Add(plate);
  const RgbaImage seen = stage.Draw();
  plate->VisibilityOff();
  check.Near(CompareImages(lit, stage.Draw()).Max, 0.0, 1e-6, "invisible plates do nothing", 1.0);
  Pass::SetCastsShadowsWhenInvisible(plate, true);
  for (const double opacity : { 1.0, 0.5 })
  {
    plate->GetProperty()->SetOpacity(opacity);
    const RgbaImage hidden = stage.Draw();
    const double light = 1.0 - opacity;
    const double expected =
      light * stage.At(lit, 0.2, 0.0) + (1.0 - light) * stage.At(seen, 0.2, 0.0);
    check.Near(stage.At(hidden, 0.2, 0.0), expected, 5e-3, "the shadow in the smoke", 1.0);
    check.Near(stage.At(hidden, 0.7, 0.0), stage.At(lit, 0.7, 0.0), 1e-6, "no plate", 1.0);
  }
}

// Parts of an assembly use the shadow keys that are set on the assembly.
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
  check.Near(stage.At(stage.Draw(), -0.3, 0.0), 0.0, DARK, "parts of an assembly", 1.0);
  Pass::SetReceivesShadows(parts, false);
  check.Near(stage.At(stage.Draw(), -0.3, 0.0), sun, 1e-3, "its parts receive no shadows", 1.0);
  Pass::SetReceivesShadows(parts, true);
  Pass::SetCastsShadows(parts, false);
  stage.Add(MakeFloor());
  check.Near(stage.At(stage.Draw(), -0.3, 0.0), sun, 1e-3, "its parts cast no shadows", 1.0);
  Pass::SetCastsShadows(parts, true);
  Pass::SetCastsShadowsWhenInvisible(parts, true);
  parts->VisibilityOff();
  check.Near(stage.At(stage.Draw(), -0.3, 0.0), 0.0, DARK, "parts of an invisible assembly", 1.0);
}

}

int TestShadowRoles(int, char*[])
{
  Check check;
  TestKeys(check);
  TestSurfaces(check);
  TestLightImages(check);
  TestSmoke(check);
  TestTranslucent(check);
  TestInvisible(check);
  TestInvisibleInSmoke(check);
  TestAssembly(check);
  return check.Result();
}

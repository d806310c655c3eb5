// SPDX-License-Identifier: BSD-3-Clause
// Images of vtkShadowedSliceMapper compared with ray marching in double precision: kinds, positions
// and numbers of lights. The scene consists of two boxes. For most lights, one box shadows the
// other.
#include "Light/ShadowComparison.h"
#include "Support/Images/CameraSettings.h"
#include "Support/Images/ShadowCases.h"
#include "Support/Drawing/ShadowImage.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkProjectiveLight.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkVolumeProperty.h"

#include <sstream>

namespace
{

using namespace reference;

constexpr ImageBound Bound = { 0.02, 0.0004 };
/// Bound for positional lights, whose brightness varies within the volume.
constexpr ImageBound PositionalBound = { 0.012, 0.0002 };
/// Bound for spotlights. A falloff exponent that is off by 10 % would exceed it.
constexpr ImageBound ConeBound = { 0.0075, 0.00013 };
constexpr ImageBound ScreenBound = { 0.008, 0.00014 };

ShadowScene BoxesScene()
{
  ShadowScene scene = MakeScene(MakeImage(20, TwoBoxes), MakeTranslucentProperty(0.7, true));
  scene.Lights.clear();
  return scene;
}

std::string ToText(const Double3& v)
{
  std::ostringstream text;
  text << v[0] << ", " << v[1] << ", " << v[2];
  return text.str();
}

void TestDirectional(Check& check)
{
  for (const Double3& direction :
    { Double3{ { 1.0, -1.0, -1.0 } }, Double3{ { 0.1, 0.2, -1.0 } }, Double3{ { -1.0, 0.1, 0.1 } },
      Double3{ { 0.3, -1.0, 0.2 } }, Double3{ { 0.2, -0.3, 1.0 } }, Double3{ { -1.0, 1.0, 1.0 } } })
  {
    auto scene = BoxesScene();
    scene.Lights = { MakeDirectionalLight(direction) };
    ExpectSimilarToReference(check, "directional along " + ToText(direction), scene, Bound);
    scene.Property->ShadeOff();
    ExpectSimilarToReference(
      check, "directional, not shaded, along " + ToText(direction), scene, Bound);
  }
}

void TestPositional(Check& check)
{
  for (const Double3& position : { Double3{ { -0.9, 1.0, 1.2 } }, Double3{ { 1.2, 0.9, 0.1 } },
         Double3{ { 0.3, 0.5, -1.4 } }, Double3{ { 0.1, 0.7, 0.65 } } })
  {
    auto scene = BoxesScene();
    scene.Lights = { MakePositionalLight(position) };
    ExpectSimilarToReference(check, "positional at " + ToText(position), scene, PositionalBound);
  }
  auto scene = BoxesScene();
  scene.Lights = { MakePositionalLight({ { -0.9, 1.0, 1.2 } }) };
  vtkLight* light = scene.Lights[0];
  // The boundary of the cone intersects the medium, and the light has half its brightness there.
  light->SetConeAngle(10.0);
  light->SetExponent(45.0);
  ExpectSimilarToReference(check, "cone", scene, ConeBound);
  light->SetConeAngle(60.0);
  ExpectSimilarToReference(check, "exponent", scene, ConeBound);
  light->SetExponent(1.0);
  light->SetConeAngle(180.0);
  light->SetIntensity(2.0);
  light->SetAttenuationValues(0.5, 0.4, 0.3);
  ExpectSimilarToReference(check, "fall-off", scene, PositionalBound);
}

void TestColors(Check& check)
{
  auto scene = BoxesScene();
  scene.Lights = { MakeDirectionalLight({ { 1.0, -1.0, -1.0 } }) };
  vtkLight* light = scene.Lights[0];
  light->SetDiffuseColor(1.0, 0.5, 0.1);
  light->SetSpecularColor(0.1, 1.0, 0.4);
  light->SetAmbientColor(0.3, 0.4, 1.0);
  ExpectSimilarToReference(check, "diffuse, specular and ambient colors", scene, Bound);
  scene.Lights.push_back(MakeDirectionalLight({ { -1.0, -1.0, -1.0 } }));
  scene.Lights[1]->SetSwitch(0);
  ExpectSimilarToReference(check, "a light that is off", scene, Bound);
  light->SetSwitch(0);
  ExpectSimilarToReference(check, "all lights off", scene, Bound);
  scene.Lights.clear();
  ExpectSimilarToReference(check, "no lights", scene, Bound);
  scene.Property->ShadeOff();
  ExpectSimilarToReference(check, "no lights, not shaded", scene, Bound);
  scene.Lights = { MakeDirectionalLight({ { 1.0, -1.0, -1.0 } }) };
  scene.Shadows = false;
  ExpectSimilarToReference(check, "no shadows, not shaded", scene, Bound);
  scene.Property->ShadeOn();
  ExpectSimilarToReference(check, "no shadows, shaded", scene, Bound);
}

void TestFollowing(Check& check)
{
  auto scene = BoxesScene();
  vtkNew<vtkLight> head;
  head->SetLightTypeToHeadlight();
  head->SetIntensity(0.8);
  scene.Lights = { head.Get() };
  ExpectSimilarToReference(check, "headlight", scene, Bound);
  vtkNew<vtkLight> camera;
  camera->SetLightTypeToCameraLight();
  camera->SetPosition(0.5, 0.8, 0.6);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetIntensity(0.8);
  scene.Lights = { camera.Get() };
  ExpectSimilarToReference(check, "camera light", scene, Bound);
}

vtkSmartPointer<vtkImageData> MakeSlide()
{
  auto slide = vtkSmartPointer<vtkImageData>::New();
  slide->SetDimensions(4, 3, 1);
  slide->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  for (vtkIdType id = 0; id < slide->GetNumberOfPoints(); ++id)
  {
    for (int k = 0; k < 4; ++k)
    {
      slide->GetPointData()->GetScalars()->SetComponent(
        id, k, k == 3 ? 155 + 20 * (id % 6) : (83 * (id + 1) * (k + 2)) % 256);
    }
  }
  return slide;
}

void TestProjective(Check& check)
{
  for (bool positional : { true, false })
  {
    const std::string kind = positional ? ", positional" : ", parallel";
    auto scene = BoxesScene();
    vtkNew<vtkProjectiveLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPositional(positional ? 1 : 0);
    light->SetConeAngle(180.0);
    light->SetPosition(-0.9, 1.0, 1.2);
    light->SetFocalPoint(-0.1, 0.1, 0.15);
    light->SetIntensity(0.9);
    light->SetScreenSize(0.6, 0.45);
    light->SetViewUp(0.2, 1.0, 0.0);
    light->SetEdgeWidth(0.4);
    scene.Lights = { light.Get() };
    ExpectSimilarToReference(check, "screen with a soft edge" + kind, scene, ScreenBound);
    light->SetImage(MakeSlide());
    light->SetScreenOpacity(0.9);
    ExpectSimilarToReference(check, "slide" + kind, scene, ScreenBound);
    scene.Property->ShadeOff();
    ExpectSimilarToReference(check, "slide, not shaded" + kind, scene, ScreenBound);
    light->InterpolateOff();
    light->SetEdgeWidth(0.0);
    // The slab thickness blurs the projected edges of the light's screen and of the slide's pixels.
    ExpectSimilarToReference(check, "sharp slide" + kind, scene, { 0.03, 0.0004 });
  }
}

void TestSeveral(Check& check)
{
  const auto red = MakeDirectionalLight({ { 1.0, -1.0, -1.0 } });
  red->SetDiffuseColor(1.0, 0.4, 0.2);
  const auto blue = MakePositionalLight({ { 1.0, 1.1, 0.9 } });
  blue->SetDiffuseColor(0.2, 0.5, 1.0);
  blue->SetIntensity(0.5);
  const auto behind = MakeDirectionalLight({ { -0.3, -0.5, 1.0 } });
  behind->SetDiffuseColor(0.3, 1.0, 0.3);
  behind->SetIntensity(0.6);
  auto scene = BoxesScene();
  scene.Lights = { red, blue };
  ExpectSimilarToReference(check, "two lights on one side", scene, Bound);
  scene.Lights = { red, behind };
  ExpectSimilarToReference(check, "two lights on both sides", scene, Bound);
  scene.Property->ShadeOff();
  ExpectSimilarToReference(check, "two lights on both sides, not shaded", scene, Bound);
  scene.Property->ShadeOn();
  scene.Lights = { red, blue, behind };
  ExpectSimilarToReference(check, "three lights", scene, Bound);
  behind->SetShadowAttenuation(0.0);
  ExpectSimilarToReference(check, "three lights, one without shadow", scene, Bound);
  blue->SetShadowAttenuation(0.3);
  ExpectSimilarToReference(check, "three lights of different shadow strengths", scene, Bound);
  // Seven lights in different directions.
  scene.Lights.clear();
  for (int i = 0; i < 7; ++i)
  {
    scene.Lights.push_back(
      MakeDirectionalLight({ { std::cos(0.9 * i), -0.6 + 0.2 * i, std::sin(0.9 * i) } }));
    scene.Lights.back()->SetIntensity(0.15);
  }
  ExpectSimilarToReference(check, "seven lights around", scene, Bound);
}

/// Only the brightest light casts shadows.
void TestMaximum(Check& check)
{
  auto scene = BoxesScene();
  scene.Lights = { MakeDirectionalLight({ { 1.0, -1.0, -1.0 } }),
    MakeDirectionalLight({ { -1.0, -1.0, -0.5 } }), MakeDirectionalLight({ { 0.1, 0.1, -1.0 } }) };
  scene.Lights[0]->SetIntensity(0.2);
  scene.Lights[1]->SetIntensity(0.5);
  scene.Lights[2]->SetIntensity(0.9);
  scene.Lights[2]->SetDiffuseColor(0.25, 0.25, 0.25);
  vtkNew<vtkShadowedSliceMapper> mapper;
  mapper->SetMaximumNumberOfShadowLights(1);
  const RgbaImage found = DrawByMapper(mapper, scene);
  check.Equal(mapper->GetReport()->GetCount("ShadowedLights"), 1, "one light casts shadows");
  scene.Lights[0]->SetShadowAttenuation(0.0);
  scene.Lights[2]->SetShadowAttenuation(0.0);
  mapper->SetMaximumNumberOfShadowLights(16);
  ExpectSimilar(
    check, "only the brightest light", found, DrawByMapper(mapper, scene), { 0.0, 0.0 });
  mapper->SetMaximumNumberOfShadowLights(0);
  DrawByMapper(mapper, scene);
  check.Equal(
    mapper->GetReport()->GetCount("LightPasses"), 0, "no light passes without shadow lights");
}

}

int TestShadowLights(int, char*[])
{
  Check check;
  TestDirectional(check);
  TestPositional(check);
  TestColors(check);
  TestFollowing(check);
  TestProjective(check);
  TestSeveral(check);
  TestMaximum(check);
  return check.Result();
}

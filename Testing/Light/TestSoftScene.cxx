// SPDX-License-Identifier: BSD-3-Clause
// Soft shadows of vtkShadowedScenePass compared with ray casting in double precision: shadows of
// surfaces on smoke, of smoke on distant surfaces, and both together; counters of lights with and
// without extent.
#include "Light/ShadowComparison.h"
#include "Support/Images/LightPoints.h"
#include "Support/Images/MixedScene.h"
#include "Support/Images/ReferenceMixedImage.h"
#include "Support/Images/ShadowCases.h"
#include "Support/Drawing/ShadowImage.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceReport.h"
#include "SceneStage.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderWindow.h"
#include "vtkShadowedScenePass.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{
using namespace reference;

constexpr double INTENSITY = 0.9;

vtkSmartPointer<vtkAreaLight> MakeRoundLight(const Double3& position, double size)
{
  auto light = vtkSmartPointer<vtkAreaLight>::New();
  light->SetPosition(position.data());
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetPositional(true);
  light->SetConeAngle(180.0);
  light->SetIntensity(INTENSITY);
  light->SetSize(size, size);
  return light;
}

/// Converts a light for the reference renderer, with \a count sample points on its emitter.
SceneLight MakeReferenceLight(vtkAreaLight* light, int count)
{
  double matrix[16];
  vtkNew<vtkMatrix4x4> emitter;
  light->GetEmitterMatrix(emitter);
  std::copy_n(emitter->GetData(), 16, matrix);
  Double3 center;
  Double3 side;
  Double3 up;
  for (int i = 0; i < 3; ++i)
  {
    side[i] = matrix[4 * i] * light->GetSize()[0];
    up[i] = matrix[4 * i + 1] * light->GetSize()[1];
    center[i] = matrix[4 * i + 3];
  }
  return { light, MakeEllipseLightPoints(center, side, up, count) };
}

struct Case
{
  std::string Name;
  std::vector<vtkSmartPointer<vtkActor>> Actors;
  bool HasSmoke = true;
  Double3 Light{ { 0.6, 0.3, 2.0 } };
  double Size = 0.6;
  Double3 View{ { 0.2, 1.0, -0.5 } };
  ImageBound Bound{ 0.06, 0.002 };
  std::vector<int> Samples{ 16 };
  int Method = vtkShadowedSliceMapper::SAMPLE_LAYERS;
};

void TestCase(Check& check, const Case& setting)
{
  ShadowScene scene = MakeHomogeneousScene(8, 2.0);
  scene.Size = { { 32, 32 } };
  scene.Camera = vtkSmartPointer<vtkCamera>::New();
  Double3 view = setting.View;
  vtkMath::Normalize(view.data());
  scene.Camera->SetPosition(-6.0 * view[0], -6.0 * view[1], -6.0 * view[2]);
  scene.Camera->SetViewUp(0.0, 0.0, 1.0);
  scene.Camera->ParallelProjectionOn();
  scene.Camera->SetParallelScale(1.0);
  scene.Camera->SetClippingRange(1.0, 12.0);
  vtkSmartPointer<vtkAreaLight> light = MakeRoundLight(setting.Light, setting.Size);
  scene.Lights = { light };
  scene.Actors = setting.Actors;

  MixedScene mixed;
  mixed.Camera = scene.Camera;
  mixed.Size = scene.Size;
  mixed.Lights = { MakeReferenceLight(light, 96) };
  if (setting.HasSmoke)
  {
    mixed.Volumes = { scene };
  }
  for (const vtkSmartPointer<vtkActor>& actor : setting.Actors)
  {
    mixed.Surfaces.push_back({ actor, {} });
  }
  const RgbaImage expected = MakeMixedImage(mixed);
  for (const int samples : setting.Samples)
  {
    vtkNew<vtkShadowedSliceMapper> mapper;
    Configure(mapper, scene);
    mapper->AutoAdjustSampleDistancesOff();
    mapper->SetSoftShadowMethod(setting.Method);
    // The mapper uses at least as many samples as the pass.
    mapper->SetNumberOfLightSamples(samples / 2);
    VolumeStage stage(scene.Size);
    SetScene(stage, mapper, scene);
    stage.GetVolume()->SetVisibility(setting.HasSmoke);
    vtkNew<vtkShadowedScenePass> pass;
    pass->SetNumberOfLightSamples(samples);
    stage.SetPass(pass);
    const RgbaImage found = stage.Capture();
    ExpectSimilar(check, setting.Name + ", " + std::to_string(samples) + " samples", found,
      expected, setting.Bound);
    pass->ReleaseGraphicsResources(stage.GetWindow());
  }
}

vtkSmartPointer<vtkActor> MakeFloor(double height)
{
  return MakeRectangle({ { -3.0, -3.0, height } }, { { 6.0, 0.0, 0.0 } }, { { 0.0, 6.0, 0.0 } });
}

void TestReference(Check& check)
{
  Case setting;
  setting.Name = "plate over smoke";
  setting.Actors = { MakeBox({ { -0.6, 0.1, -0.6, 0.6, 0.8, 0.85 } }) };
  TestCase(check, setting);
  setting.Name = "sphere in smoke on a floor";
  setting.Actors = { MakeFloor(-0.5), MakeSphereActor({ { 0.1, 0.0, 0.1 } }, 0.3, 64) };
  TestCase(check, setting);
  setting.Name = "smoke far above a floor";
  setting.Actors = { MakeFloor(-2.0) };
  setting.View = { { 0.1, 0.3, -1.0 } };
  setting.Samples = { 16, 64 };
  TestCase(check, setting);
  setting.Name = "plate as wide as the smoke, far above a floor";
  setting.Actors = { MakeFloor(-2.0), MakeBox({ { -0.5, 0.5, -0.5, 0.5, 0.6, 0.65 } }) };
  // For many points, the plate and the smoke block the same part of the light. Multiplying their
  // mean transmittances would cause a mean error of 0.013.
  setting.Bound = { 0.08, 0.005 };
  TestCase(check, setting);
  setting.Samples = { 16 };
  // Edges of surfaces are aliased.
  setting.Bound = { 1.0, 0.003 };
  setting.View = { { 0.2, 1.0, -0.5 } };
  setting.Name = "plate and sphere on a floor";
  setting.HasSmoke = false;
  setting.Actors = { MakeFloor(-0.5), MakeSphereActor({ { 0.3, 0.0, -0.2 } }, 0.3, 64),
    MakeBox({ { -0.8, -0.1, -0.6, 0.6, 0.2, 0.21 } }) };
  TestCase(check, setting);
}

/// A light of size 0 requires the same work and results in the same image as a light without
/// extent. A light with one sample has a single shadow map, too.
void TestHard(Check& check)
{
  RgbaImage images[3];
  ReportCopy reports[3];
  ReportCopy slices[3];
  for (int i = 0; i < 3; ++i)
  {
    SceneStage stage(64);
    stage.Add(MakeFloor(-0.5));
    stage.Add(MakeSphereActor({ { 0.1, 0.0, 0.4 } }, 0.3, 32));
    stage.AddSmoke({ { -0.5, 0.5, -0.5, 0.5, -0.4, 0.1 } }, 2.0);
    vtkSmartPointer<vtkLight> light = MakePointLight({ { 0.5, 0.2, 2.0 } }, { { 0.0, 0.0, 0.0 } });
    if (i > 0)
    {
      light = MakeRoundLight({ { 0.5, 0.2, 2.0 } }, i == 1 ? 0.0 : 0.4);
      light->SetIntensity(1.0);
    }
    stage.Mapper->SetNumberOfLightSamples(i == 2 ? 1 : 16);
    stage.Pass->SetNumberOfLightSamples(i == 2 ? 1 : 16);
    stage.Stage.SetLights({ light });
    images[i] = stage.Draw();
    reports[i] = CopyReport(stage.GetReport());
    slices[i] = CopyReport(stage.Mapper->GetReport());
    const std::string name = "hard light " + std::to_string(i);
    check.Equal(reports[i]->GetCount("AreaLights") + reports[i]->GetCount("SampleMaps") +
        reports[i]->GetCount("SampleMapsDrawn") + reports[i]->GetCount("SampleMapResolution"),
      0, name + ": sample maps");
    check.Equal(reports[i]->GetCount("SampleMapBytes"), 0, name + ": sample map bytes");
    check.Equal(reports[i]->GetCount("DepthMaps"), 1, name + ": shadow maps");
    check.Equal(reports[i]->GetCount("DepthMapBytes"), reports[0]->GetCount("DepthMapBytes"),
      name + ": bytes");
  }
  check.Near(CompareImages(images[1], images[0]).Max, 0.0, 0.0, "a light of size 0", 1.0);
  check.That(slices[1]->GetText("Features") == slices[0]->GetText("Features"),
    "features with a light of size 0");
  check.Equal(slices[1]->GetCount("LightPasses"), slices[0]->GetCount("LightPasses"),
    "light passes with a light of size 0");
  check.Equal(reports[1]->GetCount("ReceiverPasses"), reports[0]->GetCount("ReceiverPasses"),
    "receivers with a light of size 0");
}

/// In a scene with surfaces, SAMPLED_LIGHTS uses sample layers and results in the same image as
/// SAMPLE_LAYERS.
void TestSampledLights(Check& check)
{
  RgbaImage images[2];
  for (int i = 0; i < 2; ++i)
  {
    SceneStage stage(64);
    stage.Add(MakeFloor(-0.5));
    stage.AddSmoke({ { -0.5, 0.5, -0.5, 0.5, -0.4, 0.1 } }, 2.0);
    stage.Mapper->SetSoftShadowMethod(
      i == 0 ? vtkShadowedSliceMapper::SAMPLE_LAYERS : vtkShadowedSliceMapper::SAMPLED_LIGHTS);
    stage.Stage.SetLights({ MakeRoundLight({ { -0.7, 0.2, 2.0 } }, 0.6) });
    images[i] = stage.Draw();
    check.Equal(
      stage.Mapper->GetReport()->GetCount("AreaLightsWithHardShadows"), 0, "no hard shadows");
    check.Equal(stage.Mapper->GetReport()->GetCount("LightLayers"), 16, "layers");
  }
  check.Near(CompareImages(images[0], images[1]).Max, 0.0, 0.0, "SAMPLED_LIGHTS in a scene", 1.0);
}

/// Draws an area light, a directional light, and both. Each light adds only its own kind of shadow
/// map.
void TestBoth(Check& check)
{
  RgbaImage images[3];
  for (int i = 0; i < 3; ++i)
  {
    SceneStage stage(64);
    stage.Add(MakeFloor(-0.5));
    stage.Add(MakeSphereActor({ { 0.1, 0.0, 0.4 } }, 0.3, 32));
    const vtkSmartPointer<vtkLight> sun = MakeSun({ { 0.6, 0.2, -1.0 } });
    const vtkSmartPointer<vtkLight> light = MakeRoundLight({ { -0.7, 0.2, 2.0 } }, 0.6);
    sun->SetIntensity(0.4);
    light->SetIntensity(0.5);
    std::vector<vtkSmartPointer<vtkLight>> lights{ sun, light };
    if (i < 2)
    {
      lights.erase(lights.begin() + 1 - i);
    }
    stage.Stage.SetLights(lights);
    images[i] = stage.Draw();
    check.Equal(stage.GetReport()->GetCount("DepthMaps"), i == 1 ? 0 : 1,
      "shadow maps of lights without extent");
    check.Equal(stage.GetReport()->GetCount("SampleMaps"), i == 0 ? 0 : 16, "sample maps");
    check.Equal(stage.GetReport()->GetCount("AreaLights"), i == 0 ? 0 : 1, "area lights");
    check.Equal(stage.GetReport()->GetCount("Lights"), i < 2 ? 1 : 2, "lights");
    stage.Draw();
    check.Equal(stage.GetReport()->GetCount("SampleMapsDrawn"), 0, "sample maps are reused");
  }
  double largest = 0.0;
  for (std::size_t i = 0; i < images[2].Values.size(); i += 4)
  {
    largest =
      std::max(largest, std::abs(images[2].Values[i] - images[0].Values[i] - images[1].Values[i]));
  }
  check.Near(largest, 0.0, 1e-6, "two lights are the sum of single lights", 1.0);
}

}

int TestSoftScene(int, char*[])
{
  Check check;
  TestHard(check);
  TestBoth(check);
  TestSampledLights(check);
  TestReference(check);
  return check.Result();
}

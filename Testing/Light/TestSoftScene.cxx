// SPDX-License-Identifier: BSD-3-Clause
// Soft shadows of vtkShadowedScenePass against the double-precision caster of meshes and volumes:
// surfaces on smoke, smoke on surfaces far behind, both at once, coloured emitters; and what the
// report says of lights with an extent and without.
#include "Light/ShadowComparison.h"
#include "Support/Pictures/LightPoints.h"
#include "Support/Pictures/MixedScene.h"
#include "Support/Pictures/ReferenceMixedPicture.h"
#include "Support/Pictures/ShadowCases.h"
#include "Support/Drawing/ShadowPicture.h"
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

/// The light for the reference, as many points of its emitter.
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
  return { light, MakeRoundPoints(center, side, up, count) };
}

struct Case
{
  std::string Name;
  std::vector<vtkSmartPointer<vtkActor>> Actors;
  bool HasSmoke = true;
  Double3 Light{ { 0.6, 0.3, 2.0 } };
  double Size = 0.6;
  Double3 View{ { 0.2, 1.0, -0.5 } };
  PictureBound Bound{ 0.06, 0.002 };
  std::vector<int> Samples{ 16 };
  int Method = vtkShadowedSliceMapper::SAMPLE_LAYERS;
};

void TestCase(Check& check, const Case& setting)
{
  ShadowScene scene = MakeHomogeneousScene(8, 2.0);
  scene.Size = { { 32, 32 } };
  scene.Camera = vtkSmartPointer<vtkCamera>::New();
  Double3 away = setting.View;
  vtkMath::Normalize(away.data());
  scene.Camera->SetPosition(-6.0 * away[0], -6.0 * away[1], -6.0 * away[2]);
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
  const RgbaPicture expected = MakeMixedPicture(mixed);
  for (const int samples : setting.Samples)
  {
    vtkNew<vtkShadowedSliceMapper> mapper;
    Configure(mapper, scene);
    mapper->AutoAdjustSampleDistancesOff();
    mapper->SetSoftShadowMethod(setting.Method);
    // Volumes take as many as the surfaces that hide them.
    mapper->SetNumberOfLightSamples(samples / 2);
    VolumeStage stage(scene.Size);
    SetScene(stage, mapper, scene);
    stage.GetVolume()->SetVisibility(setting.HasSmoke);
    vtkNew<vtkShadowedScenePass> pass;
    pass->SetNumberOfLightSamples(samples);
    stage.SetPass(pass);
    const RgbaPicture found = stage.Capture();
    ExpectAlike(check, setting.Name + ", " + std::to_string(samples) + " samples", found, expected,
      setting.Bound);
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
  setting.Name = "ball in smoke on a floor";
  setting.Actors = { MakeFloor(-0.5), MakeBall({ { 0.1, 0.0, 0.1 } }, 0.3, 64) };
  TestCase(check, setting);
  setting.Name = "smoke far above a floor";
  setting.Actors = { MakeFloor(-2.0) };
  setting.View = { { 0.1, 0.3, -1.0 } };
  setting.Samples = { 16, 64 };
  TestCase(check, setting);
  setting.Name = "plate as wide as the smoke, far above a floor";
  setting.Actors = { MakeFloor(-2.0), MakeBox({ { -0.5, 0.5, -0.5, 0.5, 0.6, 0.65 } }) };
  // Both hide the same part of the light from many a place; the product of their means would be
  // 0.013 off in the mean.
  setting.Bound = { 0.08, 0.005 };
  TestCase(check, setting);
  setting.Samples = { 16 };
  // Edges of surfaces are those of pixels.
  setting.Bound = { 1.0, 0.003 };
  setting.View = { { 0.2, 1.0, -0.5 } };
  setting.Name = "plate and ball on a floor";
  setting.HasSmoke = false;
  setting.Actors = { MakeFloor(-0.5), MakeBall({ { 0.3, 0.0, -0.2 } }, 0.3, 64),
    MakeBox({ { -0.8, -0.1, -0.6, 0.6, 0.2, 0.21 } }) };
  TestCase(check, setting);
}

/// A light of size 0, or of one sample, and one without extent: the same picture, work and shaders.
void TestHard(Check& check)
{
  RgbaPicture pictures[3];
  ReportCopy reports[3];
  ReportCopy slices[3];
  for (int i = 0; i < 3; ++i)
  {
    SceneStage stage(64);
    stage.Add(MakeFloor(-0.5));
    stage.Add(MakeBall({ { 0.1, 0.0, 0.4 } }, 0.3, 32));
    stage.AddSmoke({ { -0.5, 0.5, -0.5, 0.5, -0.4, 0.1 } }, 2.0);
    vtkSmartPointer<vtkLight> lamp = MakeLamp({ { 0.5, 0.2, 2.0 } }, { { 0.0, 0.0, 0.0 } });
    if (i > 0)
    {
      lamp = MakeRoundLight({ { 0.5, 0.2, 2.0 } }, i == 1 ? 0.0 : 0.4);
      lamp->SetIntensity(1.0);
    }
    stage.Mapper->SetNumberOfLightSamples(i == 2 ? 1 : 16);
    stage.Pass->SetNumberOfLightSamples(i == 2 ? 1 : 16);
    stage.Stage.SetLights({ lamp });
    pictures[i] = stage.Draw();
    reports[i] = CopyReport(stage.GetReport());
    slices[i] = CopyReport(stage.Mapper->GetReport());
    const std::string name = "hard light " + std::to_string(i);
    check.Near(reports[i]->GetNumber("AreaLights") + reports[i]->GetNumber("SampleMaps") +
        reports[i]->GetNumber("SampleMapsDrawn") + reports[i]->GetNumber("SampleMapResolution"),
      0, 0.0, name + ": maps of samples");
    check.Near(reports[i]->GetNumber("SampleMapBytes"), 0, 0.0, name + ": bytes of samples");
    check.Near(reports[i]->GetNumber("DepthMaps"), 1, 0.0, name + ": maps");
    check.Near(reports[i]->GetNumber("DepthMapBytes"), reports[0]->GetNumber("DepthMapBytes"), 0.0,
      name + ": bytes");
  }
  check.Near(ComparePictures(pictures[1], pictures[0]).Max, 0.0, 0.0, "a light of size 0", 1.0);
  check.That(
    slices[1]->GetText("Features") == slices[0]->GetText("Features"), "features of size 0");
  check.Near(slices[1]->GetNumber("LightPasses"), slices[0]->GetNumber("LightPasses"), 0.0,
    "light passes of size 0");
  check.Near(reports[1]->GetNumber("ReceiverPasses"), reports[0]->GetNumber("ReceiverPasses"), 0.0,
    "receivers of size 0");
}

/// Lights of samples are layers in a scene, of the same samples: the same picture.
void TestSampledLights(Check& check)
{
  RgbaPicture pictures[2];
  for (int i = 0; i < 2; ++i)
  {
    SceneStage stage(64);
    stage.Add(MakeFloor(-0.5));
    stage.AddSmoke({ { -0.5, 0.5, -0.5, 0.5, -0.4, 0.1 } }, 2.0);
    stage.Mapper->SetSoftShadowMethod(
      i == 0 ? vtkShadowedSliceMapper::SAMPLE_LAYERS : vtkShadowedSliceMapper::SAMPLED_LIGHTS);
    stage.Stage.SetLights({ MakeRoundLight({ { -0.7, 0.2, 2.0 } }, 0.6) });
    pictures[i] = stage.Draw();
    check.Near(stage.Mapper->GetReport()->GetNumber("AreaLightsWithHardShadows"), 0, 0.0,
      "no hard light instead");
    check.Near(stage.Mapper->GetReport()->GetNumber("LightLayers"), 16, 0.0, "layers");
  }
  check.Near(
    ComparePictures(pictures[0], pictures[1]).Max, 0.0, 0.0, "lights of samples in a scene", 1.0);
}

/// One light with an extent among others: each has maps of its kind alone.
void TestBoth(Check& check)
{
  RgbaPicture pictures[3];
  for (int i = 0; i < 3; ++i)
  {
    SceneStage stage(64);
    stage.Add(MakeFloor(-0.5));
    stage.Add(MakeBall({ { 0.1, 0.0, 0.4 } }, 0.3, 32));
    const vtkSmartPointer<vtkLight> sun = MakeSun({ { 0.6, 0.2, -1.0 } });
    const vtkSmartPointer<vtkLight> lamp = MakeRoundLight({ { -0.7, 0.2, 2.0 } }, 0.6);
    sun->SetIntensity(0.4);
    lamp->SetIntensity(0.5);
    std::vector<vtkSmartPointer<vtkLight>> lights{ sun, lamp };
    if (i < 2)
    {
      lights.erase(lights.begin() + 1 - i);
    }
    stage.Stage.SetLights(lights);
    pictures[i] = stage.Draw();
    check.Near(stage.GetReport()->GetNumber("DepthMaps"), i == 1 ? 0 : 1, 0.0,
      "maps of lights without extent");
    check.Near(stage.GetReport()->GetNumber("SampleMaps"), i == 0 ? 0 : 16, 0.0, "maps of samples");
    check.Near(stage.GetReport()->GetNumber("AreaLights"), i == 0 ? 0 : 1, 0.0, "area lights");
    check.Near(stage.GetReport()->GetNumber("Lights"), i < 2 ? 1 : 2, 0.0, "lights");
    stage.Draw();
    check.Near(
      stage.GetReport()->GetNumber("SampleMapsDrawn"), 0, 0.0, "maps of samples drawn again");
  }
  double largest = 0.0;
  for (std::size_t i = 0; i < pictures[2].Values.size(); i += 4)
  {
    largest = std::max(
      largest, std::abs(pictures[2].Values[i] - pictures[0].Values[i] - pictures[1].Values[i]));
  }
  check.Near(largest, 0.0, 1e-6, "two lights are the sum of each", 1.0);
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

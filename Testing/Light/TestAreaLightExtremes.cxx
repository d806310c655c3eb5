// SPDX-License-Identifier: BSD-3-Clause
// Extreme and invalid area lights: positions and sizes of the emitter, non-finite values, invalid
// emitter images.
#include "Support/Pages/StabilityCase.h"
#include "Support/Images/CameraSettings.h"
#include "Support/Images/ReferenceShadowImage.h"
#include "Support/Images/ShadowCases.h"
#include "Support/Drawing/ShadowImage.h"

#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkTestErrorObserver.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <limits>
#include <sstream>

namespace
{

using namespace reference;

const double NotANumber = std::numeric_limits<double>::quiet_NaN();

/// Number of samples per light, in the mapper and the reference. It is small, since each light
/// inside the volume adds a loop to the shader, and llvmpipe takes minutes to compile four such
/// loops.
constexpr int Samples = 2;

/// Returns a scene of two boxes, one in the shadow of the other, without gradient shading.
ShadowScene BoxScene()
{
  auto scene = MakeScene(MakeImage(16, TwoBoxes), MakeTranslucentProperty(0.4, false));
  scene.Size = { { 16, 16 } };
  return scene;
}

/// Returns a round light at a position, aimed at the origin, without a spot cone or attenuation.
vtkSmartPointer<vtkAreaLight> MakeAreaLight(const Double3& position, double size)
{
  auto light = vtkSmartPointer<vtkAreaLight>::New();
  light->SetLightTypeToSceneLight();
  light->PositionalOn();
  light->SetConeAngle(180.0);
  light->SetPosition(position.data());
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetIntensity(0.8);
  light->SetSize(size, size);
  return light;
}

/// Returns a copy of a scene, lit by one light per sample of an area light.
ShadowScene WithSamples(const ShadowScene& scene, vtkAreaLight* area, int count)
{
  ShadowScene sampled = scene;
  sampled.Lights.clear();
  for (const vtkAreaLight::Sample& sample : area->GetSamples(count))
  {
    auto light = vtkSmartPointer<vtkLight>::New();
    // vtkLight::DeepCopy() is not virtual, so it copies no members of vtkAreaLight.
    light->DeepCopy(area);
    light->SetPosition(sample.Position[0], sample.Position[1], sample.Position[2]);
    light->SetIntensity(area->GetIntensity() * sample.Weight[0]);
    sampled.Lights.push_back(light);
  }
  return sampled;
}

class AreaTable
{
public:
  AreaTable(int argc, char* argv[])
    : Catalogue("TestAreaLightExtremes", argc, argv)
  {
    this->Catalogue.SetClass("vtkAreaLight");
  }

  /// Compares the mapper's frame with the reference frame, which has one light per sample. The
  /// mapper uses SAMPLE_LAYERS, or SAMPLED_LIGHTS if the light is too close or too large.
  void Measure(
    const std::string& name, const std::string& extreme, vtkAreaLight* area, double bound = 6e-4)
  {
    ShadowScene scene = BoxScene();
    this->Measure(name, extreme, scene, area, bound);
  }

  void Measure(const std::string& name, const std::string& extreme, ShadowScene scene,
    vtkAreaLight* area, double bound)
  {
    const RgbaImage expected = MakeShadowImage(WithSamples(scene, area, Samples));
    scene.Lights = { area };
    vtkNew<vtkShadowedSliceMapper> mapper;
    mapper->SetNumberOfLightSamples(Samples);
    mapper->SetLightBufferSize(64);
    RgbaImage found = DrawByMapper(mapper, scene);
    if (mapper->GetReport()->GetNumber("AreaLightsWithHardShadows") > 0)
    {
      // The light is too close or too large for SAMPLE_LAYERS.
      mapper->SetSoftShadowMethodToSampledLights();
      found = DrawByMapper(mapper, scene);
    }
    const bool isSeen = LargestAlpha(expected) > 0.05;
    this->Catalogue.Measure(name, extreme, "mean channel error against samples of the light",
      isSeen ? CompareImages(found, expected).Mean : std::nan(""), bound);
  }

  /// Expects that the frames of two scenes are identical.
  void ExpectIdentical(const std::string& name, const std::string& extreme, const ShadowScene& one,
    const ShadowScene& other)
  {
    vtkNew<vtkShadowedSliceMapper> first;
    vtkNew<vtkShadowedSliceMapper> second;
    this->Catalogue.Measure(name, extreme, "identical images",
      CompareImages(DrawByMapper(first, one), DrawByMapper(second, other)).Max, 0.0);
  }

  StabilityCatalogue Catalogue;
};

void TestPositions(AreaTable& table)
{
  const Double3 above{ { -0.9, 0.9, 0.9 } };
  table.Measure("area-light", "none", MakeAreaLight(above, 0.5));
  table.Measure(
    "area-larger-than-scene", "a light of ten times the volume's size", MakeAreaLight(above, 10.0));
  table.Measure("area-touching-receiver", "a light in the plane of the volume's face",
    MakeAreaLight({ { 0.0, 0.0, 0.5 } }, 0.5));
  table.Measure("area-through-face", "a light half inside the volume",
    MakeAreaLight({ { -0.4, 0.0, 0.45 } }, 0.6));
  table.Measure(
    "area-inside-occluder", "a light inside a box", MakeAreaLight({ { 0.05, 0.02, 0.1 } }, 0.2));
  table.Measure("area-around-volume", "a light whose disk intersects the volume",
    MakeAreaLight({ { 0.0, 0.0, 1e-3 } }, 4.0));
  table.Measure(
    "area-far", "a light 1e6 away, 1e5 wide", MakeAreaLight({ { -6e5, 4.8e5, 6.4e5 } }, 1e5));
  vtkSmartPointer<vtkAreaLight> light = MakeAreaLight({ { 1.2, 0.0, 1.2 } }, 0.8);
  light->SetFocalPoint(1.2, 5.0, 1.2);
  table.Measure("area-edge-on", "a light seen edge-on", light);
  light = MakeAreaLight(above, 1.0);
  light->SetSize(1.0, 0.0);
  table.Measure("area-line", "a light without height", light);

  Double3 camera;
  BoxScene().Camera->GetPosition(camera.data());
  table.Measure("area-at-eye", "a light around the camera", MakeAreaLight(camera, 0.5));
  table.Measure("area-opposite", "a light opposite to the camera",
    MakeAreaLight({ { -camera[0], -camera[1], -camera[2] } }, 0.5));
  table.Measure(
    "area-across", "a light perpendicular to the view", MakeAreaLight({ { 1.6, -1.2, 0.0 } }, 0.5));

  light = MakeAreaLight(above, 0.5);
  light->PositionalOff();
  table.Measure("area-directional", "a directional light", light);
  light->SetSize(4.0, 4.0);
  table.Measure(
    "area-directional-wide", "a directional light as large as half the sky", light, 3e-3);

  // The occluder is also the receiver: one layer of voxels, facing the light.
  ShadowScene scene = BoxScene();
  scene.Image = MakeImage({ { 16, 16, 1 } }, { { 0.06, 0.06, 0.06 } },
    [](const Double3& x) {
      return TwoBoxes({ { x[0], x[1], 0.5 } });
    });
  scene.Camera = LookAt(scene.Image, { { -0.3, -0.4, -1.0 } }, false);
  table.Measure("area-flat-volume", "a volume of one voxel layer", scene,
    MakeAreaLight({ { 0.0, 0.0, 1.0 } }, 1.0), 6e-4);
}

void TestSizes(AreaTable& table)
{
  const Double3 above{ { -0.9, 0.9, 0.9 } };
  ShadowScene point = BoxScene();
  point.Lights = { MakePositionalLight(above) };
  ShadowScene area = point;
  area.Lights = { MakeAreaLight(above, 0.0) };
  table.ExpectIdentical("area-size-0", "size 0, compared with a point light", area, point);
  vtkSmartPointer<vtkAreaLight> light = MakeAreaLight(above, 0.0);
  light->PositionalOff();
  area.Lights = { light };
  point.Lights = { MakeDirectionalLight({ { 1.0, -1.0, -1.0 } }) };
  table.ExpectIdentical(
    "area-directional-size-0", "size 0, compared with a directional light", area, point);

  for (const double size : { 1e-300, 1e-30, 1e-9 })
  {
    std::ostringstream name;
    name << "area-size-" << size;
    table.Measure(name.str(), "a tiny size", MakeAreaLight(above, size));
  }
  light = MakeAreaLight(above, 0.5);
  for (const double size : { 1e6, 1e30 })
  {
    light->SetSize(size, size);
    area.Lights = { light };
    vtkNew<vtkShadowedSliceMapper> mapper;
    mapper->SetNumberOfLightSamples(Samples);
    mapper->SetLightBufferSize(64);
    const RgbaImage found = DrawByMapper(mapper, area);
    bool isFinite = true;
    for (const double value : found.Values)
    {
      isFinite = isFinite && value >= 0.0 && value <= 1.001;
    }
    std::ostringstream name;
    name << "area-size-" << size;
    table.Catalogue.Check(name.str(), "a huge size",
      "colors from 0 to 1, and an image that is not empty",
      "largest opacity " + std::to_string(LargestAlpha(found)),
      isFinite && LargestAlpha(found) > 0.05);
  }
}

/// Expects an error for an invalid light, and a frame that is lit only by the valid light.
void ExpectError(AreaTable& table, const std::string& name, const std::string& extreme,
  const std::string& text, vtkAreaLight* light)
{
  ShadowScene scene = BoxScene();
  scene.Lights = { MakePositionalLight({ { -0.9, 0.9, 0.9 } }) };
  vtkNew<vtkShadowedSliceMapper> without;
  const RgbaImage expected = DrawByMapper(without, scene);
  scene.Lights.push_back(light);
  vtkNew<vtkShadowedSliceMapper> mapper;
  vtkNew<vtkTest::ErrorObserver> observer;
  mapper->AddObserver(vtkCommand::ErrorEvent, observer);
  mapper->AddObserver(vtkCommand::WarningEvent, observer);
  const double difference = CompareImages(DrawByMapper(mapper, scene), expected).Max;
  const std::string message = observer->GetErrorMessage() + observer->GetWarningMessage();
  table.Catalogue.Check(name, extreme, "\"" + text + "\", and the other light remains", message,
    message.find(text) != std::string::npos && difference == 0.0);
}

void TestErrors(AreaTable& table)
{
  const Double3 position{ { 1.0, 1.0, 1.0 } };
  vtkSmartPointer<vtkAreaLight> light = MakeAreaLight(position, 0.5);
  light->SetPosition(0.0, NotANumber, 1.0);
  ExpectError(table, "area-position-nan", "a position of NaN", "not finite", light);
  light = MakeAreaLight(position, 0.5);
  light->SetFocalPoint(light->GetPosition());
  ExpectError(table, "area-without-direction", "position and focal point the same",
    "position and focal point are the same", light);
  light = MakeAreaLight(position, 0.5);
  vtkNew<vtkImageData> image;
  light->SetEmitter(image);
  ExpectError(
    table, "area-empty-emitter", "an image without samples", "emitter has no samples", light);
  vtkNew<vtkImageData> wide;
  wide->SetDimensions(2, 2, 1);
  wide->AllocateScalars(VTK_BIT, 1);
  light->SetEmitter(wide);
  ExpectError(table, "area-bit-emitter", "an image of bits", "type bit", light);

  ShadowScene scene = BoxScene();
  scene.Lights = { MakeAreaLight({ { -0.9, 0.9, 0.9 } }, 0.5) };
  ShadowScene dark = scene;
  vtkSmartPointer<vtkAreaLight> black = MakeAreaLight(position, 0.5);
  vtkNew<vtkImageData> night;
  night->SetDimensions(2, 2, 1);
  night->AllocateScalars(VTK_FLOAT, 1);
  for (int i = 0; i < 4; ++i)
  {
    night->SetScalarComponentFromDouble(i % 2, i / 2, 0, 0, i < 3 ? 0.0 : NotANumber);
  }
  black->SetEmitter(night);
  black->SetAmbientColor(0.0, 0.0, 0.0);
  dark.Lights.push_back(black);
  table.ExpectIdentical(
    "area-black-emitter", "an image of 0 and NaN, compared with no such light", dark, scene);

  vtkSmartPointer<vtkAreaLight> same = MakeAreaLight({ { -0.9, 0.9, 0.9 } }, 0.5);
  vtkNew<vtkTest::ErrorObserver> observer;
  same->AddObserver(vtkCommand::ErrorEvent, observer);
  int errors = 0;
  const double sizes[3][2] = { { -1.0, 1.0 }, { 1.0, NotANumber },
    { std::numeric_limits<double>::infinity(), 1.0 } };
  for (const auto& size : sizes)
  {
    same->SetSize(size[0], size[1]);
    errors += observer->GetError() ? 1 : 0;
    observer->Clear();
  }
  table.Catalogue.Check("area-size-errors", "sizes below 0, NaN and infinite",
    "one error per size, and the size is retained", std::to_string(errors) + " errors",
    errors == 3 && same->GetSize()[0] == 0.5 && same->GetSize()[1] == 0.5);
}
}

int TestAreaLightExtremes(int argc, char* argv[])
{
  AreaTable table(argc, argv);
  TestPositions(table);
  TestSizes(table);
  TestErrors(table);
  return table.Catalogue.GetExitCode();
}

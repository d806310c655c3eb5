// SPDX-License-Identifier: BSD-3-Clause
// Extremes of area lights, each by its name: places and sizes of the emitter, values that are no
// numbers, images that are none.
#include "Support/Pages/StabilityCase.h"
#include "Support/Pictures/PictureSettings.h"
#include "Support/Pictures/ReferenceShadowPicture.h"
#include "Support/Pictures/ShadowCases.h"
#include "Support/Drawing/ShadowPicture.h"

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

/// The number of samples of a light, in the mapper and the reference. Each light inside the volume
/// has a loop in the shader, and llvmpipe compiles a shader of four such loops for minutes.
constexpr int Samples = 2;

/// Two boxes, one in the other's shadow, whose parts scatter light evenly.
ShadowScene BoxScene()
{
  auto scene = MakeScene(MakeImage(16, TwoBoxes), MakeSoftProperty(0.4, false));
  scene.Size = { { 16, 16 } };
  return scene;
}

/// A round light that shines from there towards the origin, without cone and fall-off.
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

/// The scene with lights without extent in the place of its area light.
ShadowScene WithSamples(const ShadowScene& scene, vtkAreaLight* area, int count)
{
  ShadowScene made = scene;
  made.Lights.clear();
  for (const vtkAreaLight::Sample& sample : area->GetSamples(count))
  {
    auto light = vtkSmartPointer<vtkLight>::New();
    // That of vtkLight, not virtual.
    light->DeepCopy(area);
    light->SetPosition(sample.Position[0], sample.Position[1], sample.Position[2]);
    light->SetIntensity(area->GetIntensity() * sample.Weight[0]);
    made.Lights.push_back(light);
  }
  return made;
}

class AreaTable
{
public:
  AreaTable(int argc, char* argv[])
    : Catalogue("TestAreaLightExtremes", argc, argv)
  {
    this->Catalogue.SetClass("vtkAreaLight");
  }

  /// The mapper's picture, by layers where the light can have them, against the mean of the
  /// reference's pictures of samples of the light.
  void Measure(
    const std::string& name, const std::string& extreme, vtkAreaLight* area, double bound = 6e-4)
  {
    ShadowScene scene = BoxScene();
    this->Measure(name, extreme, scene, area, bound);
  }

  void Measure(const std::string& name, const std::string& extreme, ShadowScene scene,
    vtkAreaLight* area, double bound)
  {
    const RgbaPicture expected = MakeShadowPicture(WithSamples(scene, area, Samples));
    scene.Lights = { area };
    vtkNew<vtkShadowedSliceMapper> mapper;
    mapper->SetNumberOfLightSamples(Samples);
    mapper->SetLightBufferSize(64);
    RgbaPicture found = DrawByMapper(mapper, scene);
    if (mapper->GetReport()->GetNumber("AreaLightsWithHardShadows") > 0)
    {
      // The light is too close or too large for layers.
      mapper->SetSoftShadowMethodToSampledLights();
      found = DrawByMapper(mapper, scene);
    }
    const bool isSeen = LargestAlpha(expected) > 0.05;
    this->Catalogue.Measure(name, extreme, "mean channel error against samples of the light",
      isSeen ? ComparePictures(found, expected).Mean : std::nan(""), bound);
  }

  /// Two pictures of the mapper that have to be the same bytes.
  void Same(const std::string& name, const std::string& extreme, const ShadowScene& one,
    const ShadowScene& other)
  {
    vtkNew<vtkShadowedSliceMapper> first;
    vtkNew<vtkShadowedSliceMapper> second;
    this->Catalogue.Measure(name, extreme, "the same bytes",
      ComparePictures(DrawByMapper(first, one), DrawByMapper(second, other)).Max, 0.0);
  }

  StabilityCatalogue Catalogue;
};

void TestPlaces(AreaTable& table)
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
  table.Measure("area-around-volume", "a light whose disc cuts the volume in two",
    MakeAreaLight({ { 0.0, 0.0, 1e-3 } }, 4.0));
  table.Measure(
    "area-far", "a light 1e6 away, 1e5 wide", MakeAreaLight({ { -6e5, 4.8e5, 6.4e5 } }, 1e5));
  vtkSmartPointer<vtkAreaLight> light = MakeAreaLight({ { 1.2, 0.0, 1.2 } }, 0.8);
  light->SetFocalPoint(1.2, 5.0, 1.2);
  table.Measure("area-edge-on", "a light that is seen from its side", light);
  light = MakeAreaLight(above, 1.0);
  light->SetSize(1.0, 0.0);
  table.Measure("area-line", "a light without height", light);

  // Of BoxScene.
  Double3 eye;
  BoxScene().Camera->GetPosition(eye.data());
  table.Measure("area-at-eye", "a light around the eye", MakeAreaLight(eye, 0.5));
  table.Measure("area-opposite", "a light opposite the eye",
    MakeAreaLight({ { -eye[0], -eye[1], -eye[2] } }, 0.5));
  table.Measure(
    "area-across", "a light across the view", MakeAreaLight({ { 1.6, -1.2, 0.0 } }, 0.5));

  light = MakeAreaLight(above, 0.5);
  light->PositionalOff();
  table.Measure("area-directional", "a light infinitely far", light);
  light->SetSize(4.0, 4.0);
  table.Measure("area-directional-wide", "half of the sky", light, 3e-3);

  // The occluder is the receiver: one layer of voxels across the light.
  ShadowScene scene = BoxScene();
  scene.Image = MakeImage({ { 16, 16, 1 } }, { { 0.06, 0.06, 0.06 } },
    [](const Double3& x) {
      return TwoBoxes({ { x[0], x[1], 0.5 } });
    });
  scene.Camera = LookAt(scene.Image, { { -0.3, -0.4, -1.0 } }, false);
  table.Measure("area-flat-volume", "a volume of one voxel", scene,
    MakeAreaLight({ { 0.0, 0.0, 1.0 } }, 1.0), 6e-4);
}

void TestSizes(AreaTable& table)
{
  const Double3 above{ { -0.9, 0.9, 0.9 } };
  ShadowScene point = BoxScene();
  point.Lights = { MakePositionalLight(above) };
  ShadowScene area = point;
  area.Lights = { MakeAreaLight(above, 0.0) };
  table.Same("area-size-0", "size 0 and a point light", area, point);
  vtkSmartPointer<vtkAreaLight> light = MakeAreaLight(above, 0.0);
  light->PositionalOff();
  area.Lights = { light };
  point.Lights = { MakeDirectionalLight({ { 1.0, -1.0, -1.0 } }) };
  table.Same("area-directional-size-0", "size 0 and a directional light", area, point);

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
    const RgbaPicture found = DrawByMapper(mapper, area);
    bool isFinite = true;
    for (const double value : found.Values)
    {
      isFinite = isFinite && value >= 0.0 && value <= 1.001;
    }
    std::ostringstream name;
    name << "area-size-" << size;
    table.Catalogue.Check(name.str(), "a huge size", "colours of 0 to 1 and the volume",
      "largest opacity " + std::to_string(LargestAlpha(found)),
      isFinite && LargestAlpha(found) > 0.05);
  }
}

/// The bad light is an error, and the picture is that of the light beside it alone.
void ExpectLeftOut(AreaTable& table, const std::string& name, const std::string& extreme,
  const std::string& words, vtkAreaLight* light)
{
  ShadowScene scene = BoxScene();
  scene.Lights = { MakePositionalLight({ { -0.9, 0.9, 0.9 } }) };
  vtkNew<vtkShadowedSliceMapper> without;
  const RgbaPicture expected = DrawByMapper(without, scene);
  scene.Lights.push_back(light);
  vtkNew<vtkShadowedSliceMapper> mapper;
  vtkNew<vtkTest::ErrorObserver> observer;
  mapper->AddObserver(vtkCommand::ErrorEvent, observer);
  mapper->AddObserver(vtkCommand::WarningEvent, observer);
  const double difference = ComparePictures(DrawByMapper(mapper, scene), expected).Max;
  const std::string message = observer->GetErrorMessage() + observer->GetWarningMessage();
  table.Catalogue.Check(name, extreme, "\"" + words + "\", and the others shine", message,
    message.find(words) != std::string::npos && difference == 0.0);
}

void TestErrors(AreaTable& table)
{
  const Double3 aside{ { 1.0, 1.0, 1.0 } };
  vtkSmartPointer<vtkAreaLight> light = MakeAreaLight(aside, 0.5);
  light->SetPosition(0.0, NotANumber, 1.0);
  ExpectLeftOut(table, "area-position-nan", "a position of NaN", "not finite", light);
  light = MakeAreaLight(aside, 0.5);
  light->SetFocalPoint(light->GetPosition());
  ExpectLeftOut(table, "area-without-direction", "position and focal point the same",
    "position and focal point are the same", light);
  light = MakeAreaLight(aside, 0.5);
  vtkNew<vtkImageData> image;
  light->SetEmitter(image);
  ExpectLeftOut(
    table, "area-empty-emitter", "an image without samples", "emitter has no samples", light);
  vtkNew<vtkImageData> wide;
  wide->SetDimensions(2, 2, 1);
  wide->AllocateScalars(VTK_SHORT, 1);
  light->SetEmitter(wide);
  ExpectLeftOut(table, "area-short-emitter", "an image of short integers", "type short", light);

  ShadowScene scene = BoxScene();
  scene.Lights = { MakeAreaLight({ { -0.9, 0.9, 0.9 } }, 0.5) };
  ShadowScene dark = scene;
  vtkSmartPointer<vtkAreaLight> black = MakeAreaLight(aside, 0.5);
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
  table.Same("area-black-emitter", "an image of 0 and NaN, and no such light", dark, scene);

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
    "an error each, and the size before", std::to_string(errors) + " errors",
    errors == 3 && same->GetSize()[0] == 0.5 && same->GetSize()[1] == 0.5);
}
}

int TestAreaLightExtremes(int argc, char* argv[])
{
  AreaTable table(argc, argv);
  TestPlaces(table);
  TestSizes(table);
  TestErrors(table);
  return table.Catalogue.GetExitCode();
}

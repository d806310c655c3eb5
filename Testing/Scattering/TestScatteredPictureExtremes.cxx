// SPDX-License-Identifier: BSD-3-Clause
// Extreme settings of ScatteringMode of vtkShadowedSliceMapper: albedo, anisotropy, depths, sizes,
// light positions, non-finite values. No setting creates light.
#include "Support/Checks/LargestError.h"
#include "Support/Pages/StabilityCase.h"
#include "Support/Images/ShadowCases.h"
#include "Support/Drawing/ShadowImage.h"
#include "Support/Images/VolumeStage.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkTestErrorObserver.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <random>
#include <string>

namespace
{

using namespace reference;
using Mapper = vtkShadowedSliceMapper;

/// Smallest value and largest color value of an image. IsFinite is true if all values are finite.
struct Range
{
  explicit Range(const RgbaImage& image)
  {
    for (int j = 0; j < image.Height; ++j)
    {
      for (int i = 0; i < image.Width; ++i)
      {
        for (int k = 0; k < 4; ++k)
        {
          const double value = image.At(i, j)[k];
          this->IsFinite = this->IsFinite && std::isfinite(value);
          this->Smallest = std::min(this->Smallest, value);
          this->Largest = std::max(this->Largest, k < 3 ? value : 0.0);
          this->Sum += k < 3 ? value : 0.0;
          this->Opacity = std::max(this->Opacity, k == 3 ? value : 0.0);
        }
      }
    }
  }
  bool IsFinite = true;
  double Smallest = 0.0;
  double Largest = 0.0;
  double Sum = 0.0;
  double Opacity = 0.0;
};

ShadowScene MakeSmallScene(int cells = 12, double opacity = 0.5)
{
  auto scene =
    MakeScene(MakeImage(cells, MakeSphere(0.1, 0.45)), MakeTranslucentProperty(opacity, false));
  return scene;
}

void SetMode(vtkShadowedSliceMapper* mapper, int mode, double g)
{
  mapper->SetScatteringMode(mode);
  mapper->SetPhaseFunctionToHenyeyGreenstein();
  mapper->SetAnisotropy(g);
}

void SetAlbedo(vtkShadowedSliceMapper* mapper, double albedo)
{
  vtkNew<vtkColorTransferFunction> function;
  function->AddRGBPoint(0.0, albedo, albedo, albedo);
  mapper->SetScatteringAlbedo(function);
}

class Table
{
public:
  Table(int argc, char* argv[])
    : Catalogue("TestScatteredPictureExtremes", argc, argv)
  {
    this->Catalogue.SetClass("vtkShadowedSliceMapper");
  }

  /// Draws the scene in all scattering modes. Values must be finite and not negative, at most \a
  /// bound, and nonzero if \a isSeen.
  void Draw(const std::string& name, const std::string& extreme, const ShadowScene& scene,
    const std::function<void(vtkShadowedSliceMapper*)>& set, double bound, bool isSeen = true)
  {
    double largest = 0.0;
    for (const int mode :
      { Mapper::SINGLE_SCATTERING, Mapper::FORWARD_SCATTERING, Mapper::FULL_SCATTERING })
    {
      vtkNew<Mapper> mapper;
      vtkNew<vtkTest::ErrorObserver> observer;
      mapper->AddObserver(vtkCommand::ErrorEvent, observer);
      mapper->AddObserver(vtkCommand::WarningEvent, observer);
      SetMode(mapper, mode, 0.0);
      set(mapper);
      const Range range(this->DrawScene(mapper, scene));
      const bool isValid = range.IsFinite && range.Smallest > -1e-4 && !observer->GetError() &&
        (range.Largest > 0.0) == isSeen;
      largest = isValid ? std::max(largest, range.Largest) : std::nan("");
      if (!isValid)
      {
        break;
      }
    }
    this->Catalogue.Measure(
      name, extreme, "finite values, none negative, largest value", largest, bound);
  }

  /// Draws in one window for all cases, so that shaders are reused.
  RgbaImage DrawScene(vtkShadowedSliceMapper* mapper, const ShadowScene& scene)
  {
    SetScene(this->Stage, mapper, scene);
    return this->Stage.Capture();
  }

  StabilityCatalogue Catalogue;

private:
  VolumeStage Stage{ { { 24, 24 } } };
};

void TestMedia(Table& table)
{
  const auto none = [](vtkShadowedSliceMapper*) {};
  for (const double albedo : { 0.0, 1.0 })
  {
    table.Draw(
      "albedo-" + std::to_string(static_cast<int>(albedo)),
      albedo > 0.0 ? "a medium without absorption" : "a medium without scattering",
      MakeSmallScene(), [=](vtkShadowedSliceMapper* mapper) { SetAlbedo(mapper, albedo); }, 4.0,
      albedo > 0.0);
  }
  for (const double g : { -0.99, -0.5, 0.5, 0.99 })
  {
    // If the light and view directions are collinear, the peak of single scattering is visible.
    table.Draw(
      "anisotropy" + std::to_string(g), "anisotropy " + std::to_string(g), MakeSmallScene(),
      [=](vtkShadowedSliceMapper* mapper)
      {
        SetMode(mapper, mapper->GetScatteringMode(), g);
        SetAlbedo(mapper, 1.0);
      },
      20.0);
  }
  for (const double depth : { 1e-6, 1e4 })
  {
    auto scene = MakeHomogeneousScene(12, 1.0);
    // Set the optical depth by the unit distance, since an opacity of 1 - exp(-1e4) rounds to 1.
    scene.Property->SetScalarOpacityUnitDistance(1.0 / depth);
    table.Draw(depth < 1.0 ? "depth-1e-6" : "depth-1e+4",
      depth < 1.0 ? "an optical depth of 1e-6" : "an optical depth of 1e4", scene, none,
      depth < 1.0 ? 1e-5 : 5.0);
  }
  auto empty = MakeHomogeneousScene(8, 1.0);
  empty.Property->GetScalarOpacity()->RemoveAllPoints();
  empty.Property->GetScalarOpacity()->AddPoint(0.0, 0.0);
  table.Draw("empty", "no medium", empty, none, 0.0, false);
  auto one = MakeHomogeneousScene(1, 2.0);
  table.Draw("one-voxel", "a volume of one voxel", one, none, 4.0);
  auto flat = MakeScene(
    MakeImage({ { 16, 16, 1 } }, { { 0.06, 0.06, 2e-3 } }, [](const Double3&) { return 1.0; }),
    MakeTranslucentProperty(0.9, false));
  table.Draw("sheet", "a sheet with a thickness of 1/500 of its width", flat, none, 4.0);
  auto values = MakeSmallScene();
  vtkDataArray* array = values.Image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); i += 5)
  {
    array->SetComponent(i, 0,
      i % 2 == 0 ? std::numeric_limits<double>::quiet_NaN()
                 : std::numeric_limits<double>::infinity());
  }
  table.Draw("nan-voxels", "voxels with NaN and infinity", values, none, 4.0);
  for (const double size : { 1e-20, 1e20 })
  {
    auto scene = MakeSmallScene();
    double spacing = size / 12.0;
    scene.Image->SetSpacing(spacing, spacing, spacing);
    scene.Image->SetOrigin(-0.5 * size, -0.5 * size, -0.5 * size);
    scene.Property->SetScalarOpacityUnitDistance(0.1 * size);
    scene.Camera = LookAt(scene.Image, { { -0.3, -0.4, -1.0 } }, false);
    table.Draw(size < 1.0 ? "size-1e-20" : "size-1e+20",
      size < 1.0 ? "a volume of 1e-20" : "a volume of 1e20", scene, none, 4.0);
  }
  auto sheared = MakeSmallScene();
  sheared.Matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  sheared.Matrix->SetElement(0, 1, 0.8);
  sheared.Matrix->SetElement(2, 2, -2.0);
  table.Draw("sheared", "skewed, mirrored axes", sheared, none, 4.0);
}

void TestLights(Table& table)
{
  const auto none = [](vtkShadowedSliceMapper*) {};
  auto scene = MakeSmallScene();
  const auto draw = [&](const std::string& name, const std::string& extreme,
                      const std::vector<vtkSmartPointer<vtkLight>>& lights, bool isSeen = true)
  {
    scene.Lights = lights;
    table.Draw(name, extreme, scene, none, 5.0, isSeen);
  };
  draw(
    "light-inside", "a light inside the volume", { MakePositionalLight({ { 0.1, 0.05, 0.15 } }) });
  draw("light-in-cell-middle", "a light at the center of a cell",
    { MakePositionalLight({ { 0.5 / 12.0, 0.5 / 12.0, 0.5 / 12.0 } }) });
  draw("light-far", "a light 1e6 away", { MakePositionalLight({ { -6e5, 4.8e5, 6.4e5 } }) });
  draw(
    "light-against", "light opposite to the view", { MakeDirectionalLight({ { 0.3, 0.4, 1.0 } }) });
  draw("light-along", "light along the view", { MakeDirectionalLight({ { -0.3, -0.4, -1.0 } }) });
  auto black = MakeDirectionalLight({ { 1.0, -1.0, -1.0 } });
  black->SetDiffuseColor(0.0, 0.0, 0.0);
  draw("light-black", "a black light", { black }, false);
  draw("no-light", "no light", {}, false);
  auto near = MakePositionalLight({ { 0.0, 0.0, 0.2 } });
  near->SetAttenuationValues(0.0, 0.0, 1.0);
  near->SetIntensity(1e-3);
  draw("light-falls-off", "a light inside with quadratic fall-off", { near });
  std::vector<vtkSmartPointer<vtkLight>> many;
  for (int i = 0; i < 16; ++i)
  {
    many.push_back(
      MakeDirectionalLight({ { std::cos(0.4 * i), std::sin(0.4 * i), i % 2 == 0 ? 0.6 : -0.6 } }));
    many.back()->SetIntensity(1.0 / 16.0);
  }
  draw("lights-16", "sixteen lights on all sides", many);
}

/// Replaces the lights with lights from all directions with total intensity 1. Each face of a cube
/// receives a quarter of this intensity, as from uniform light.
void SetUniformLight(ShadowScene& scene)
{
  scene.Lights.clear();
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    scene.Lights.push_back(MakeDirectionalLight(
      { { corner & 1u ? 1.0 : -1.0, corner & 2u ? 1.0 : -1.0, corner & 4u ? 1.0 : -1.0 } }));
    scene.Lights.back()->SetIntensity(0.683013 / 8.0);
  }
  for (std::size_t side = 0; side < 6; ++side)
  {
    Double3 direction{};
    direction[side / 2] = side % 2 == 0 ? 1.0 : -1.0;
    scene.Lights.push_back(MakeDirectionalLight(direction));
    scene.Lights.back()->SetIntensity(0.316987 / 6.0);
  }
}

/// Optically thick cubes without absorption, lit from all directions, reflect all light: each
/// opaque pixel is close to 1 for any optical depth per cell of the scattering grid.
void TestThickCubes(Table& table)
{
  vtkNew<Mapper> mapper;
  mapper->SetLightBufferSize(32);
  SetMode(mapper, Mapper::FULL_SCATTERING, 0.0);
  SetAlbedo(mapper, 1.0);
  for (const int cells : { 4, 8, 16 })
  {
    mapper->SetScatteringGridSize(cells);
    double brightest = 0.0;
    double largestLoss = 0.0;
    for (const double depth : { 1e1, 1e2, 1e3, 1e4 })
    {
      auto scene = MakeHomogeneousScene(cells, 1.0);
      scene.Property->SetScalarOpacityUnitDistance(1.0 / (depth * cells));
      SetUniformLight(scene);
      const RgbaImage image = table.DrawScene(mapper, scene);
      for (int p = 0; p < 24 * 24; ++p)
      {
        const auto pixel = image.At(p % 24, p / 24);
        for (int color = 0; color < 3 && pixel[3] > 0.9999; ++color)
        {
          KeepLargest(brightest, static_cast<double>(pixel[color]));
          KeepLargest(largestLoss, 1.0 - pixel[color]);
        }
      }
    }
    const std::string name = "thick-cube-" + std::to_string(cells);
    const std::string extreme =
      "depths of 1e1 to 1e4 in each of " + std::to_string(cells) + " cells along the edges";
    // Cells at the edges of thick media are brighter than cells at the faces.
    table.Catalogue.Measure(name, extreme, "largest pixel relative to the surrounding light",
      brightest > 0.0 ? brightest : std::nan(""), 1.25);
    table.Catalogue.Measure(name + "-dark", extreme,
      "surrounding light minus the smallest opaque pixel", largestLoss, 0.17);
  }
}

/// Lights the scene from all directions with total intensity 1. For random settings, no pixel is
/// much brighter than 1, and no image is brighter on average than its opacity.
void TestRandomSettings(Table& table, int settings, bool isThin)
{
  std::mt19937 random(3);
  const auto uniform = [&random](double from, double to)
  { return from + (to - from) * static_cast<double>(random() % 10000) / 9999.0; };
  double brightest = 0.0;
  double brightestMean = 0.0;
  vtkNew<Mapper> mapper;
  mapper->SetLightBufferSize(32);
  for (int i = 0; i < settings; ++i)
  {
    ShadowScene scene = i % 2 == 0 ? MakeHomogeneousScene(8, 1.0) : MakeSmallScene(8, 0.9);
    scene.Property->SetScalarOpacityUnitDistance(
      std::pow(10.0, uniform(isThin ? -1.0 : -3.0, 2.0)));
    SetUniformLight(scene);
    // Draws random numbers in a fixed order: compilers evaluate arguments in different orders.
    const Double3 position{ { uniform(-1.0, 1.0), uniform(-1.0, 1.0), -1.0 } };
    scene.Camera = LookAt(scene.Image, position, random() % 2 == 0);
    const int mode = 1 + static_cast<int>(random() % 3);
    // Phase functions narrower than the angle between lights would resolve individual lights.
    SetMode(mapper, mode, uniform(-0.3, 0.3));
    SetAlbedo(mapper, random() % 2 == 0 ? 1.0 : uniform(0.0, 1.0));
    mapper->SetForwardSpread(random() % 2 == 0 ? 0.0 : uniform(0.0, 1.0));
    mapper->SetScatteringGridSize(random() % 2 == 0 ? 0 : 4 + static_cast<int>(random() % 5));
    const RgbaImage image = table.DrawScene(mapper, scene);
    const Range range(image);
    double sum = 0.0;
    double opacity = 0.0;
    for (int p = 0; p < 24 * 24; ++p)
    {
      sum += image.At(p % 24, p / 24)[1];
      opacity += image.At(p % 24, p / 24)[3];
    }
    if (range.Largest > 1.05)
    {
      std::cout << "setting " << i << ": " << range.Largest << ", mean " << sum / opacity
                << ", mode " << mapper->GetScatteringMode() << ", g " << mapper->GetAnisotropy()
                << ", unit " << scene.Property->GetScalarOpacityUnitDistance() << ", spread "
                << mapper->GetForwardSpread() << ", cells " << mapper->GetScatteringGridSize()
                << std::endl;
    }
    const bool isValid = range.IsFinite && range.Smallest > -1e-4;
    brightest = isValid ? std::max(brightest, range.Largest) : std::nan("");
    brightestMean = std::max(brightestMean, opacity > 0.0 ? sum / opacity : 0.0);
    if (!isValid)
    {
      break;
    }
  }
  // If cells are optically thick, cells at the edges of the medium are brighter than cells at its
  // faces.
  const std::string name = isThin ? "random-settings" : "random-settings-thick";
  const std::string extreme = std::to_string(settings) + " random settings" +
    (isThin ? ", depths to 10" : ", depths to 1e3 in 4 to 8 cells");
  table.Catalogue.Measure(name, extreme, "largest pixel relative to the surrounding light",
    brightest, isThin ? 1.05 : 1.25);
  table.Catalogue.Measure(name + "-mean", extreme,
    "largest mean of an image relative to the surrounding light", brightestMean,
    isThin ? 1.03 : 1.06);
}

}

int TestScatteredPictureExtremes(int argc, char* argv[])
{
  Table table(argc, argv);
  TestMedia(table);
  TestLights(table);
  TestThickCubes(table);
  TestRandomSettings(table, 60, true);
  TestRandomSettings(table, 60, false);
  return table.Catalogue.GetExitCode();
}

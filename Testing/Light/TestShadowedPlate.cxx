// SPDX-License-Identifier: BSD-3-Clause
// Compares an unshaded plate, whose opacity increases to 1 within about one voxel, with its exact
// brightness. The optical depths of light and view have a constant ratio, so that the brightness
// does not depend on the opacity ramp. Slices and light buffer texels must not cause visible
// patterns.
#include "Support/Images/CameraSettings.h"
#include "Support/Images/RgbaImage.h"
#include "Support/Images/ShadowCases.h"
#include "Support/Drawing/ShadowImage.h"
#include "Support/Images/VolumeStage.h"
#include "Support/Checks/ReferenceCheck.h"

#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace
{

using namespace reference;

constexpr int VOXELS = 96;
constexpr int LAYERS = 16;
constexpr int PIXELS = 160;

/// Returns a plate whose density increases from 0 above its surface to 1 below it. The density is a
/// step smoothed by a Gaussian with a standard deviation of 1.14 voxels.
vtkSmartPointer<vtkImageData> MakePlate()
{
  return MakeImage({ { VOXELS, VOXELS, LAYERS } }, { { 1.0, 1.0, 1.0 } },
    [](const Double3& x)
    {
      const double depth = LAYERS * (0.5 - x[2]) + 0.37;
      return 0.5 + 0.5 * std::erf(depth / (1.14 * std::sqrt(2.0)));
    });
}

/// Returns a medium that becomes opaque within a voxel, at densities between 80 and 175 of 255.
vtkSmartPointer<vtkVolumeProperty> MakeMedium(bool isShaded)
{
  vtkSmartPointer<vtkVolumeProperty> property =
    MakeProperty({ { 80.0 / 255.0, { { 1.0, 1.0, 1.0 } }, 0.0 },
      { 175.0 / 255.0, { { 1.0, 1.0, 1.0 } }, 0.998 } });
  property->SetShade(isShaded ? 1 : 0);
  property->SetAmbient(0.0);
  property->SetDiffuse(1.0);
  property->SetSpecular(0.0);
  return property;
}

enum Kinds
{
  PLAIN,
  /// In the red channel, the extinction along light rays is halved.
  COLORED,
  NEAREST,
  /// Two lights from opposite sides, each with half the intensity.
  TWO_LIGHTS,
  /// The volume is cropped by a plane that is parallel to the plate and inside the opacity ramp, so
  /// that the medium has a sharp boundary.
  CROPPED
};

struct Case
{
  std::string Name;
  /// View and light directions.
  Double3 View;
  Double3 Light;
  /// Edge length of the light buffer, or 0 for the default.
  int BufferSize;
  bool IsShaded;
  /// Diameter of the light, or 0 for a directional light.
  double Diameter;
  /// Bounds of the roughness (root mean square) and of the error of the mean, in units of 1/255.
  double Roughness;
  double Bias;
  Kinds Kind = PLAIN;
};

/// Subtracts the best-fitting polynomial of degree two from a square of pixels.
void RemoveQuadric(std::vector<double>& values, int size)
{
  // Gram-Schmidt orthogonalization of the monomials.
  std::vector<std::vector<double>> basis;
  for (const auto& power : std::array<std::array<int, 2>, 6>{
         { { { 0, 0 } }, { { 1, 0 } }, { { 0, 1 } }, { { 2, 0 } }, { { 1, 1 } }, { { 0, 2 } } } })
  {
    std::vector<double> column;
    for (int j = 0; j < size; ++j)
    {
      for (int i = 0; i < size; ++i)
      {
        column.push_back(
          std::pow(2.0 * i / size - 1.0, power[0]) * std::pow(2.0 * j / size - 1.0, power[1]));
      }
    }
    const auto project = [](std::vector<double>& v, const std::vector<double>& unit)
    {
      double along = 0.0;
      for (std::size_t k = 0; k < v.size(); ++k)
      {
        along += v[k] * unit[k];
      }
      for (std::size_t k = 0; k < v.size(); ++k)
      {
        v[k] -= along * unit[k];
      }
    };
    for (const std::vector<double>& unit : basis)
    {
      project(column, unit);
    }
    double square = 0.0;
    for (const double value : column)
    {
      square += value * value;
    }
    for (double& value : column)
    {
      value /= std::sqrt(square);
    }
    project(values, column);
    basis.push_back(column);
  }
}

vtkSmartPointer<vtkLight> MakeLight(const Case& plate, double intensity)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  if (plate.Diameter > 0.0)
  {
    auto area = vtkSmartPointer<vtkAreaLight>::New();
    area->SetShapeToRound();
    area->SetSize(plate.Diameter, plate.Diameter);
    light = area;
  }
  // An area light is far away, so its light is almost parallel.
  const double distance = plate.Diameter > 0.0 ? 800.0 : 1.0;
  light->SetLightTypeToSceneLight();
  light->SetPositional(plate.Diameter > 0.0);
  light->SetConeAngle(180.0);
  const double length = vtkMath::Norm(plate.Light.data());
  light->SetPosition(-distance / length * plate.Light[0], -distance / length * plate.Light[1],
    -distance / length * plate.Light[2]);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetIntensity(intensity);
  return light;
}

void TestPlate(Check& check, const Case& plate)
{
  check.SetContext(plate.Name);
  const double seen = -plate.View[2] / vtkMath::Norm(plate.View.data());
  const double lit = -plate.Light[2] / vtkMath::Norm(plate.Light.data());
  constexpr double bright = 187.0;
  // Over all optical depths a along a view ray, the integral of exp(-a - a * seen / lit) is
  // 1 / (1 + seen / lit).
  const double fraction = plate.Kind == COLORED ? 0.5 : 1.0;
  const double intensity =
    bright / 255.0 * (1.0 + fraction * seen / lit) / (plate.IsShaded ? lit : 1.0);

  vtkNew<vtkShadowedSliceMapper> mapper;
  mapper->SetInputData(MakePlate());
  mapper->SetSliceSpacing(0.5);
  mapper->SetLightBufferSize(plate.BufferSize);
  mapper->SetNumberOfLightSamples(24);
  mapper->AutoAdjustSampleDistancesOff();
  if (plate.Kind == COLORED)
  {
    vtkNew<vtkColorTransferFunction> transmission;
    transmission->AddRGBPoint(0.0, 1.0 - fraction, 0.2, 0.8);
    mapper->SetTransmissionColor(transmission);
  }
  if (plate.Kind == CROPPED)
  {
    mapper->CroppingOn();
    // If the visible regions form a box, the mapper treats it as a smaller volume. To prevent this,
    // a corner region outside the image is visible, too.
    mapper->SetCroppingRegionPlanes(-40.0, 40.0, -40.0, 40.0, -LAYERS, 0.3);
    mapper->SetCroppingRegionFlags(0x7ffff);
  }
  mapper->SetLightLookup(plate.Kind == NEAREST ? vtkShadowedSliceSettings::NEAREST_LOOKUP
                                               : vtkShadowedSliceSettings::BILINEAR_LOOKUP);
  VolumeStage stage(std::array<int, 2>{ { PIXELS, PIXELS } });
  stage.SetVolume(mapper, MakeMedium(plate.IsShaded));
  vtkNew<vtkCamera> camera;
  camera->SetParallelProjection(1);
  camera->SetParallelScale(12.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(-200.0 * plate.View[0], -200.0 * plate.View[1], -200.0 * plate.View[2]);
  camera->SetViewUp(0.0, 1.0, 0.3);
  camera->SetClippingRange(1.0, 1000.0);
  stage.SetCamera(camera);
  Case mirrored = plate;
  mirrored.Light = { { -plate.Light[0], -plate.Light[1], plate.Light[2] } };
  const bool isSplit = plate.Kind == TWO_LIGHTS;
  stage.SetLights({ MakeLight(plate, isSplit ? 0.5 * intensity : intensity),
    MakeLight(mirrored, isSplit ? 0.5 * intensity : 0.0) });
  const RgbaImage image = stage.Capture();

  std::vector<double> values;
  double mean = 0.0;
  double opacity = 1.0;
  for (std::size_t k = 0; k < image.Values.size(); k += 4)
  {
    values.push_back(255.0 * image.Values[k]);
    mean += values.back() / (PIXELS * PIXELS);
    opacity = std::min<double>(opacity, image.Values[k + 3]);
  }
  RemoveQuadric(values, PIXELS);
  double square = 0.0;
  for (double& value : values)
  {
    square += value * value;
    value = std::abs(value);
  }
  const double roughness = std::sqrt(square / values.size());
  std::sort(values.begin(), values.end());
  std::cout << plate.Name << ": roughness " << roughness << ", 99 % within "
            << values[values.size() * 99 / 100] << ", mean error " << mean - bright << " of 255, "
            << mapper->GetReport()->GetNumber("LightBufferSize") << "^2" << std::endl;
  check.That(opacity > 0.999, "the plate is opaque");
  check.Near(roughness, 0.0, plate.Roughness, "roughness", 1.0);
  check.Near(mean, bright, plate.Bias, "mean", 1.0);
}

}

int TestShadowedPlate(int, char*[])
{
  Check check;
  const Double3 flat = { { 0.3, -1.0, -0.36 } };
  const Double3 steep = { { 0.3, 0.6, -0.8 } };
  const Double3 down = { { 0.5, 0.1, -0.9 } };
  const Double3 across = { { -0.5, 0.2, -0.9 } };
  const Double3 grazing = { { 0.8, 0.1, -0.5 } };
  // For comparison: with one sample at the center of each slab and interpolated transmittance,
  // these cases would have the following (roughness, bias): (0.55, 6.7), (0.55, 6.7), (1.3, 1.2),
  // (2.1, 1.1), (2.8, 1.5), (0.7, 3.4), (1.3, 1.2), (0.7, 1.1), (0.3, 2.7), (1.9, 1.4), (1.9, 1.6),
  // (5.2, 11.8), (5.3, 0.7), (1.7, 3.1), (1.7, 3.2), (1.5, 0.2).
  const std::vector<Case> cases = { { "flat view", flat, { { -0.1, 0.05, -1.0 } }, 192, true, 0.0,
                                      0.2, 0.5 },
    { "flat view, not shaded", flat, { { -0.1, 0.05, -1.0 } }, 192, false, 0.0, 0.2, 0.5 },
    { "steep view", steep, across, 192, true, 0.0, 0.6, 0.5 },
    { "light close to the view", down, { { 0.6, -0.2, -0.7 } }, 192, true, 0.0, 0.65, 0.8 },
    { "grazing light", down, grazing, 192, true, 0.0, 0.45, 0.3 },
    { "light opposite to the view", { { -0.7, 0.1, -0.3 } }, { { 0.8, 0.1, -0.4 } }, 192, true, 0.0,
      0.4, 0.6 },
    { "round light", steep, across, 192, true, 10.0, 0.6, 0.5 },
    { "colored transmission", steep, across, 192, true, 0.0, 0.55, 0.5, COLORED },
    { "colored transmission, light opposite to the view", { { -0.7, 0.1, -0.3 } },
      { { 0.8, 0.1, -0.4 } }, 192, true, 0.0, 0.5, 0.7, COLORED },
    { "two lights", steep, across, 192, true, 0.0, 0.55, 0.3, TWO_LIGHTS },
    { "cropped", steep, across, 192, true, 0.0, 2.2, 1.2, CROPPED },
    { "cropped, light opposite to the view", { { -0.7, 0.1, -0.3 } }, { { 0.8, 0.1, -0.4 } }, 192,
      true, 0.0, 2.2, 4.5, CROPPED },
    { "nearest texels", steep, across, 192, true, 0.0, 6.0, 1.0, NEAREST },
    { "automatic buffer", steep, across, 0, true, 0.0, 0.7, 0.5 },
    { "round light, automatic buffer", steep, across, 0, true, 10.0, 0.9, 1.1 },
    { "steep view, fine texels", steep, across, 768, true, 0.0, 0.4, 0.3 } };
  for (const Case& plate : cases)
  {
    TestPlate(check, plate);
  }
  return check.Result();
}

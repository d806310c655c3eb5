// Sharp surfaces in vtkShadowedSliceMapper against closed forms, at its own settings: an opaque
// cube, and plates whose opacity jumps between two voxels, under light and view from 0 to 60
// degrees.
#include "Pictures/PictureCases.h"
#include "Pictures/ReferenceRay.h"
#include "Pictures/ShadowCases.h"
#include "Pictures/ShadowPicture.h"
#include "Reference/Checks/ReferenceCheck.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace
{

using namespace reference;

struct Errors
{
  double Mean = 0.0;
  double P95 = 0.0;
  double Max = 0.0;
  /// Over the mean of what is expected.
  double Rms = 0.0;
};

/// Over the pixels for which a number is expected.
Errors Measure(const std::string& name, const RgbaPicture& found,
  const std::function<double(int, int)>& expected)
{
  std::vector<double> all;
  double squares = 0.0;
  double level = 0.0;
  Errors errors;
  for (int j = 0; j < found.Height; ++j)
  {
    for (int i = 0; i < found.Width; ++i)
    {
      const double value = expected(i, j);
      if (std::isfinite(value))
      {
        all.push_back(std::abs(found.At(i, j)[0] - value));
        errors.Mean += all.back();
        squares += all.back() * all.back();
        level += value;
      }
    }
  }
  std::sort(all.begin(), all.end());
  const auto count = static_cast<double>(all.size());
  errors.Mean /= count;
  errors.P95 = all[static_cast<std::size_t>(0.95 * (count - 1.0))];
  errors.Max = all.back();
  errors.Rms = std::sqrt(squares / count) / (level / count);
  std::cout << name << ": mean " << errors.Mean << ", 95 % below " << errors.P95 << ", largest "
            << errors.Max << ", rms " << errors.Rms << std::endl;
  return errors;
}

/// White, lit by diffuse light alone, opaque from a value on.
vtkSmartPointer<vtkVolumeProperty> MakeOpaque(double from, double voxel)
{
  const Point3 white = { { 1.0, 1.0, 1.0 } };
  auto property = MakeProperty(
    { { 0.0, white, 0.0 }, { from - 1e-4, white, 0.0 }, { from, white, 1.0 }, { 1.0, white, 1.0 } },
    voxel);
  property->SetAmbient(0.0);
  property->SetDiffuse(1.0);
  return property;
}

/// What a ray meets first of the cube, lit along the light: a surface of cosines e and l with them
/// has l / (e + l), as both fall alike within it.
double GetCubePixel(const Ray& ray, const Double3& toLight)
{
  double enter = 0.0;
  double leave = VTK_DOUBLE_MAX;
  double value = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    const auto from = static_cast<double>(ray.Origin[k]);
    const auto along = static_cast<double>(ray.Direction[k]);
    const double side = along > 0.0 ? -0.5 : 0.5;
    leave = std::min(leave, (-side - from) / along);
    if ((side - from) / along > enter)
    {
      enter = (side - from) / along;
      const double light = side > 0.0 ? toLight[k] : -toLight[k];
      value = light > 0.0 ? light / (light + std::abs(along)) : 0.0;
    }
  }
  return leave > enter ? value : std::nan("");
}

void TestCube(Check& check)
{
  constexpr int cells = 24;
  auto scene =
    MakeScene(MakeImage(cells, [](const Double3&) { return 1.0; }), MakeOpaque(0.5, 1.0 / cells));
  scene.Lights[0]->SetIntensity(1.0);
  scene.Size = { { 96, 96 } };
  vtkNew<vtkShadowedSliceMapper> mapper;
  const RgbaPicture found = DrawByMapper(mapper, scene);
  const PixelRays rays(scene.Camera, scene.Size);
  const double third = std::sqrt(1.0 / 3.0);
  const Errors errors = Measure("cube", found,
    [&](int i, int j) {
      return GetCubePixel(rays.Get(i, j), { { -third, third, third } });
    });
  check.Near(errors.Mean, 0.0, 0.01, "cube, mean error", 1.0);
  check.Near(errors.P95, 0.0, 0.01, "cube, error of 95 % of the pixels", 1.0);
}

/// A direction down on the plate, from its normal by an angle and around it.
Double3 GetDirection(const Double3& normal, double angle, double around)
{
  Double3 first;
  Double3 second;
  vtkMath::Perpendiculars(normal.data(), first.data(), second.data(), 0.0);
  const double a = vtkMath::RadiansFromDegrees(angle);
  const double b = vtkMath::RadiansFromDegrees(around);
  Double3 direction;
  for (int k = 0; k < 3; ++k)
  {
    direction[k] =
      -std::cos(a) * normal[k] + std::sin(a) * (std::cos(b) * first[k] + std::sin(b) * second[k]);
  }
  return direction;
}

Errors MeasurePlate(Double3 normal, double light, double eye, double around, double spacing)
{
  constexpr int cells = 32;
  constexpr double voxel = 1.0 / cells;
  vtkMath::Normalize(normal.data());
  const Field field = [&](const Double3& x)
  {
    const double height =
      (x[0] - 0.5) * normal[0] + (x[1] - 0.5) * normal[1] + (x[2] - 0.503) * normal[2];
    return vtkMath::ClampValue(0.5 - 0.5 * height / voxel, 0.0, 1.0);
  };
  auto scene = MakeScene(MakeImage(cells, field), MakeOpaque(0.5, voxel));
  scene.Lights = { MakeDirectionalLight(GetDirection(normal, light, around)) };
  scene.Lights[0]->SetIntensity(1.0);
  scene.Camera = LookAt(scene.Image, GetDirection(normal, eye, 0.0), true);
  scene.Camera->SetParallelScale(0.15);
  vtkNew<vtkShadowedSliceMapper> mapper;
  mapper->SetSliceSpacing(spacing * voxel);
  if (spacing > 0.0)
  {
    mapper->SetLightBufferSize(static_cast<int>(cells / spacing));
  }
  const double e = std::cos(vtkMath::RadiansFromDegrees(eye));
  const double l = std::cos(vtkMath::RadiansFromDegrees(light));
  const std::string name = "plate, light " + std::to_string(static_cast<int>(light)) + ", eye " +
    std::to_string(static_cast<int>(eye)) + ", around " + std::to_string(static_cast<int>(around)) +
    (normal[2] < 1.0 ? ", tilted" : "") +
    (spacing > 0.0 ? ", spacing " + std::to_string(spacing) : "");
  return Measure(name, DrawByMapper(mapper, scene), [&](int, int) { return l / (l + e); });
}

void TestPlates(Check& check)
{
  const Double3 straight = { { 0.0, 0.0, 1.0 } };
  const Double3 tilted = { { 0.2, 0.35, 1.0 } };
  for (const double light : { 0.0, 20.0, 40.0, 50.0, 60.0 })
  {
    for (const auto& [eye, around] :
      { std::pair<double, double>{ 0.0, 0.0 }, std::pair<double, double>{ 30.0, 120.0 } })
    {
      for (const Double3& normal : { straight, tilted })
      {
        const Errors errors = MeasurePlate(normal, light, eye, around, 0.0);
        check.Near(errors.Rms, 0.0, 0.025, "plate under light at " + std::to_string(light), 1.0);
      }
    }
  }
  const Errors coarse = MeasurePlate(tilted, 50.0, 30.0, 120.0, 1.0);
  const Errors fine = MeasurePlate(tilted, 50.0, 30.0, 120.0, 0.25);
  check.That(fine.Mean < 0.7 * coarse.Mean, "the error falls with spacing and buffer");
}

}

int TestShadowSurfaces(int, char*[])
{
  Check check;
  TestCube(check);
  TestPlates(check);
  return check.Result();
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Images/SurfaceCases.h"

#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Images/CameraSettings.h"
#include "Support/Images/ReferenceRay.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <ostream>
#include <vector>

namespace reference
{

namespace
{

constexpr Point3 White = { { 1.0, 1.0, 1.0 } };

/// Returns a white property with diffuse reflection only. \a opacities contains pairs of a scalar
/// and its opacity over the distance \a voxel.
vtkSmartPointer<vtkVolumeProperty> MakeWhite(
  const std::vector<std::array<double, 2>>& opacities, double voxel)
{
  std::vector<FunctionNode> nodes;
  nodes.reserve(opacities.size());
  for (const std::array<double, 2>& opacity : opacities)
  {
    nodes.push_back({ opacity[0], White, opacity[1] });
  }
  auto property = MakeProperty(nodes, voxel);
  property->SetAmbient(0.0);
  property->SetDiffuse(1.0);
  return property;
}

/// Returns a property whose opacity jumps from 0 to 1 at the scalar 0.5.
vtkSmartPointer<vtkVolumeProperty> MakeOpaque(double voxel)
{
  return MakeWhite(
    { { { 0.0, 0.0 } }, { { 0.5 - 1e-4, 0.0 } }, { { 0.5, 1.0 } }, { { 1.0, 1.0 } } }, voxel);
}

/// Returns the brightness of the cube where a ray enters it, for a directional light, or NaN if the
/// ray misses. If e and l are the cosines of the angles between the face normal and the directions
/// to the camera and the light, the brightness is l / (e + l), since light is attenuated at the
/// same rate on both paths.
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

/// Returns the direction toward a surface at the given angle to its normal. \a around is the
/// azimuth.
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

ShadowScene MakeLit(int cells, const Field& field, vtkVolumeProperty* property)
{
  ShadowScene scene = MakeScene(MakeImage(cells, field), property);
  scene.Lights[0]->SetIntensity(1.0);
  scene.Size = { { 96, 96 } };
  return scene;
}

}

SurfaceCase MakeOpaqueCube(int cells)
{
  SurfaceCase result;
  result.Scene = MakeLit(
    cells, [](const Double3&) { return 1.0; }, MakeOpaque(1.0 / cells));
  const auto rays = std::make_shared<PixelRays>(result.Scene.Camera, result.Scene.Size);
  const double third = std::sqrt(1.0 / 3.0);
  result.Expected = [rays, third](int i, int j) {
    return GetCubePixel(rays->Get(i, j), { { -third, third, third } });
  };
  return result;
}

SurfaceCase MakePlate(int cells, Double3 normal, double light, double eye, double around)
{
  const double voxel = 1.0 / cells;
  vtkMath::Normalize(normal.data());
  const Field field = [&](const Double3& x)
  {
    const double height =
      (x[0] - 0.5) * normal[0] + (x[1] - 0.5) * normal[1] + (x[2] - 0.503) * normal[2];
    return vtkMath::ClampValue(0.5 - 0.5 * height / voxel, 0.0, 1.0);
  };
  SurfaceCase result;
  result.Scene = MakeScene(MakeImage(cells, field), MakeOpaque(voxel));
  result.Scene.Lights = { MakeDirectionalLight(GetDirection(normal, light, around)) };
  result.Scene.Lights[0]->SetIntensity(1.0);
  result.Scene.Camera = LookAt(result.Scene.Image, GetDirection(normal, eye, 0.0), true);
  result.Scene.Camera->SetParallelScale(0.15);
  const double e = std::cos(vtkMath::RadiansFromDegrees(eye));
  const double l = std::cos(vtkMath::RadiansFromDegrees(light));
  result.Expected = [e, l](int, int) { return l / (l + e); };
  return result;
}

SurfaceErrors MeasureSurface(const RgbaImage& found, const PixelFunction& expected)
{
  std::vector<double> all;
  double squares = 0.0;
  double level = 0.0;
  double excess = 0.0;
  for (const auto& [j, i] : AllIndices(found.Height, found.Width))
  {
    const double value = expected(i, j);
    if (std::isfinite(value))
    {
      const double difference = found.At(i, j)[0] - value;
      all.push_back(std::abs(difference));
      squares += difference * difference;
      excess += difference;
      level += value;
    }
  }
  SurfaceErrors errors;
  if (all.empty())
  {
    return errors;
  }
  std::sort(all.begin(), all.end());
  const auto count = static_cast<double>(all.size());
  for (const double error : all)
  {
    errors.Mean += error / count;
  }
  errors.P95 = all[static_cast<std::size_t>(0.95 * (count - 1.0))];
  errors.Max = all.back();
  errors.Rms = std::sqrt(squares / count) / (level / count);
  errors.Bias = excess / level;
  return errors;
}

std::ostream& operator<<(std::ostream& os, const SurfaceErrors& errors)
{
  return os << "mean " << errors.Mean << ", 95th percentile " << errors.P95 << ", largest "
            << errors.Max << ", rms " << errors.Rms << ", brightness error " << errors.Bias;
}

}

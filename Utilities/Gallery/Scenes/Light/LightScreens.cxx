// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Scenes/Light/LightScreens.h"

#include "Gallery/Scenes/Light/ShadowScene.h"
#include "Gallery/Stage.h"

#include "vtkShadowedSliceMapper.h"

#include <algorithm>
#include <cmath>

namespace gallery
{
namespace
{
double SmoothStep(double t)
{
  const double clamped = std::max(0.0, std::min(t, 1.0));
  return clamped * clamped * (3.0 - 2.0 * clamped);
}
}

vtkSmartPointer<vtkImageData> MakePattern(
  int width, int height, const std::function<vtkColor3d(double, double)>& pattern)
{
  constexpr int subsamples = 4;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int j = 0; j < height; ++j)
  {
    for (int i = 0; i < width; ++i)
    {
      vtkColor3d sum(0.0, 0.0, 0.0);
      for (int k = 0; k < subsamples * subsamples; ++k)
      {
        const int row = k / subsamples;
        const double x = i + (k - row * subsamples + 0.5) / subsamples;
        const double y = j + (row + 0.5) / subsamples;
        const vtkColor3d color = pattern(x / width, y / height);
        for (int c = 0; c < 3; ++c)
        {
          sum[c] += color[c];
        }
      }
      auto* sample = static_cast<unsigned char*>(image->GetScalarPointer(i, j, 0));
      for (int c = 0; c < 3; ++c)
      {
        sample[c] =
          static_cast<unsigned char>(std::lround(255.0 / (subsamples * subsamples) * sum[c]));
      }
    }
  }
  return image;
}

vtkSmartPointer<vtkImageData> MakeGridPattern(int lines, double fraction)
{
  constexpr int size = 1024;
  return MakePattern(size, size,
    [lines, fraction](double u, double v)
    {
      const auto isOnLine = [lines, fraction](double x)
      { return std::abs(x * lines - std::floor(x * lines) - 0.5) < 0.5 * fraction; };
      const double gray = isOnLine(u) || isOnLine(v) ? 0.0 : 1.0;
      return vtkColor3d(gray, gray, gray);
    });
}

vtkSmartPointer<vtkImageData> MakeSoftDiskImage(double edge)
{
  constexpr int size = 256;
  return MakePattern(size, size,
    [edge](double u, double v)
    {
      const double radius = 2.0 * std::hypot(u - 0.5, v - 0.5);
      const double gray = SmoothStep((0.98 - radius) / edge);
      return vtkColor3d(gray, gray, gray);
    });
}

vtkSmartPointer<vtkProjectiveLight> MakeProjector(const vtkVector3d& position,
  const vtkVector3d& center, double width, double height, double intensity, vtkImageData* image)
{
  auto light = vtkSmartPointer<vtkProjectiveLight>::New();
  light->SetLightTypeToSceneLight();
  light->PositionalOn();
  light->SetConeAngle(180.0);
  light->SetPosition(position[0], position[1], position[2]);
  light->SetFocalPoint(center[0], center[1], center[2]);
  light->SetViewUp(0.0, 0.0, 1.0);
  light->SetScreenSize(width, height);
  light->SetIntensity(intensity);
  light->SetImage(image);
  return light;
}

vtkSmartPointer<vtkProjectiveLight> MakeParallelProjector(const vtkVector3d& position,
  const vtkVector3d& center, double width, double height, double intensity, vtkImageData* image)
{
  vtkSmartPointer<vtkProjectiveLight> light =
    MakeProjector(position, center, width, height, intensity, image);
  light->PositionalOff();
  return light;
}

vtkSmartPointer<vtkLight> MakeFillLight(const vtkVector3d& from, double intensity)
{
  vtkSmartPointer<vtkLight> light = MakeParallelLight(from, intensity);
  light->SetDiffuseColor(0.86, 0.92, 1.0);
  light->SetShadowAttenuation(0.0F);
  return light;
}

vtkSmartPointer<vtkProjectiveLight> MakeBeam(const vtkVector3d& position, const vtkVector3d& center,
  double diameter, double intensity, const vtkColor3d& color)
{
  vtkSmartPointer<vtkProjectiveLight> light =
    MakeParallelProjector(position, center, diameter, diameter, intensity, MakeSoftDiskImage(0.3));
  light->SetDiffuseColor(color[0], color[1], color[2]);
  return light;
}

Panel& AddPatternPanel(Stage& stage, vtkImageData* image, vtkProjectiveLight* light)
{
  vtkSmartPointer<vtkVolume> volume = MakeSlicedVolume(image, MakeSolidMedium(image));
  // Slices are closer together than in other scenes. Otherwise, they would be visible on bright
  // walls.
  GetSlicedMapper(volume)->SetSliceSpacing(0.3 * image->GetSpacing()[0]);
  Panel& panel = stage.AddPanel("");
  panel.Add(volume);
  panel.SetLights({ light, MakeFillLight({ 1.0, -1.0, 0.6 }, 0.2) });
  panel.SetBackground({ 0.36, 0.36, 0.38 }, { 0.20, 0.20, 0.22 });
  panel.Frame(vtkBoundingBox(-0.98, 1.02, -0.1, 0.1, -0.24, 1.02));
  return panel;
}
}

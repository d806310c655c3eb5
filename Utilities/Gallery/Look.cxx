// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Look.h"

#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

#include <array>
#include <vector>

namespace gallery
{
namespace
{
/// Returns the colors of evenly spaced control points from the lower to the upper end of the map.
/// The darkest tenth of viridis and the darkest fifth of inferno are excluded, since shading is not
/// visible on these colors.
std::vector<vtkColor3d> ControlPoints(Map map)
{
  switch (map)
  {
    case Map::Viridis:
      return { { 0.283, 0.141, 0.458 }, { 0.254, 0.265, 0.530 }, { 0.207, 0.372, 0.553 },
        { 0.164, 0.471, 0.558 }, { 0.128, 0.567, 0.551 }, { 0.135, 0.659, 0.518 },
        { 0.267, 0.749, 0.441 }, { 0.478, 0.821, 0.318 }, { 0.741, 0.873, 0.150 },
        { 0.993, 0.906, 0.144 } };
    case Map::Inferno:
      return { { 0.258, 0.039, 0.406 }, { 0.416, 0.090, 0.433 }, { 0.578, 0.148, 0.404 },
        { 0.736, 0.216, 0.330 }, { 0.865, 0.317, 0.226 }, { 0.955, 0.455, 0.106 },
        { 0.987, 0.622, 0.040 }, { 0.965, 0.804, 0.196 }, { 0.988, 0.998, 0.645 } };
    case Map::CoolWarm:
      break;
  }
  return { { 0.230, 0.299, 0.754 }, { 0.383, 0.510, 0.918 }, { 0.553, 0.690, 0.996 },
    { 0.722, 0.816, 0.976 }, { 0.865, 0.865, 0.865 }, { 0.957, 0.769, 0.678 },
    { 0.957, 0.596, 0.478 }, { 0.871, 0.376, 0.302 }, { 0.706, 0.016, 0.150 } };
}
}

vtkSmartPointer<vtkLight> MakeCameraLight(double x, double y, double z, double intensity)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToCameraLight();
  light->SetPosition(x, y, z);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetIntensity(intensity);
  return light;
}

vtkColor3d Background()
{
  return { 0.925, 0.929, 0.933 };
}

vtkColor3d DarkBackground()
{
  return { 0.065, 0.072, 0.085 };
}

vtkColor3d TextColor()
{
  return { 0.13, 0.15, 0.18 };
}

vtkColor3d OutlineColor()
{
  return { 0.62, 0.64, 0.67 };
}

vtkColor3d IntervalColor(int i)
{
  static const std::array<vtkColor3d, 6> colors = { { { 0.220, 0.440, 0.720 },
    { 0.278, 0.655, 0.580 }, { 0.929, 0.694, 0.263 }, { 0.788, 0.286, 0.231 },
    { 0.494, 0.341, 0.600 }, { 0.545, 0.565, 0.585 } } };
  return colors[static_cast<std::size_t>(i) % colors.size()];
}

vtkSmartPointer<vtkColorTransferFunction> MakeColorMap(Map map, double lower, double upper)
{
  auto function = vtkSmartPointer<vtkColorTransferFunction>::New();
  const std::vector<vtkColor3d> points = ControlPoints(map);
  const double step = (upper - lower) / static_cast<double>(points.size() - 1);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    function->AddRGBPoint(
      lower + static_cast<double>(i) * step, points[i][0], points[i][1], points[i][2]);
  }
  return function;
}

void ApplyLook(vtkRenderer* renderer)
{
  const vtkColor3d background = Background();
  renderer->SetBackground(background[0], background[1], background[2]);
  renderer->AutomaticLightCreationOff();
  renderer->RemoveAllLights();
  renderer->AddLight(MakeCameraLight(-0.7, 0.9, 1.0, 0.80));
  renderer->AddLight(MakeCameraLight(1.2, 0.2, 0.9, 0.45));
  renderer->AddLight(MakeCameraLight(0.0, 0.0, 1.0, 0.24));
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Tetrahedra/FieldImage.h"

#include "Support/Images/ReferenceFunction.h"
#include "Support/Images/ReferenceRay.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace
{
/// Returns the ray parameters at which a view ray enters and leaves the cube. The ray misses the
/// cube if the first parameter is not smaller than the second.
std::array<double, 2> Chord(const reference::Ray& ray, double low, double high)
{
  double entry = 0.0;
  double exit = 1e30;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto a = static_cast<double>((low - ray.Origin[axis]) / ray.Direction[axis]);
    const auto b = static_cast<double>((high - ray.Origin[axis]) / ray.Direction[axis]);
    entry = std::max(entry, std::min(a, b));
    exit = std::min(exit, std::max(a, b));
  }
  return { { entry, exit } };
}
}

reference::RgbaImage RenderField(const std::function<double(double, double, double)>& field,
  double low, double high, vtkVolumeProperty* property, vtkCamera* camera,
  const std::array<int, 2>& size, int steps)
{
  const reference::PiecewiseLinearFunction color(property->GetRGBTransferFunction());
  const reference::PiecewiseLinearFunction opacity(property->GetScalarOpacity());
  const double unit = property->GetScalarOpacityUnitDistance();
  const reference::PixelRays rays(camera, size);
  reference::RgbaImage image(size[0], size[1]);
  auto drawPixel = [&](int i, int j)
  {
    const reference::Ray ray = rays.Get(i, j);
    const std::array<double, 2> chord = Chord(ray, low, high);
    const double step = (chord[1] - chord[0]) / steps;
    double* pixel = image.At(i, j);
    double transmittance = 1.0;
    auto valueAt = [&](double distance)
    {
      double x[3];
      for (int k = 0; k < 3; ++k)
      {
        x[k] = static_cast<double>(ray.Origin[k] + distance * ray.Direction[k]);
      }
      return field(x[0], x[1], x[2]);
    };
    for (int s = 0; s < steps && step > 0.0; ++s)
    {
      const double value = valueAt(chord[0] + (s + 0.5) * step);
      const double alpha = -std::expm1(-step * opacity.Evaluate(value)[0] / unit);
      const auto colorHere = color.Evaluate(value);
      for (int k = 0; k < 3; ++k)
      {
        pixel[k] += transmittance * alpha * colorHere[k];
      }
      transmittance *= 1.0 - alpha;
    }
    pixel[3] = 1.0 - transmittance;
  };
  vtkSMPTools::For(0, size[1],
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int j = static_cast<int>(begin); j < static_cast<int>(end); ++j)
      {
        for (int i = 0; i < size[0]; ++i)
        {
          drawPixel(i, j);
        }
      }
    });
  return image;
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Images/HalfPlane.h"

#include "Support/Images/ShadowCases.h"

#include "vtkAreaLight.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>

namespace reference
{

namespace
{

constexpr double Width = 0.5;
constexpr double Gap = 0.5;
/// Number of layers of samples in the volume along z.
constexpr int Layers = 97;
constexpr int Pixels = 192;
/// Number of pixels skipped at the shadowed end of the image, where light gets past the outer edge
/// of the sheet.
constexpr int SkippedPixels = 38;
/// Fraction of the volume's width that the camera shows.
constexpr double VisibleFraction = 0.9;

vtkSmartPointer<vtkImageData> MakeSheets(double thickness)
{
  const Field field = [](const Double3& x)
  {
    // The receiver is eight layers above the bottom. The sheet is two layers below the top, so that
    // a light can be close to it.
    const double layer = x[2] * (Layers - 1);
    const bool isReceiver = std::abs(layer - 8.0) < 0.6;
    const bool isSheet = std::abs(layer - (Layers - 3.0)) < 0.6;
    return isReceiver ? -1.0 : isSheet && x[0] < 0.5 ? 1.0 : 0.0;
  };
  auto image =
    MakeImage({ { 128, 4, Layers - 1 } }, { { Width / 128.0, Width / 128.0, thickness } }, field);
  double origin[3];
  image->GetOrigin(origin);
  image->SetOrigin(origin[0], origin[1], -(Layers - 3.0) * thickness);
  return image;
}

vtkSmartPointer<vtkVolumeProperty> MakeMedium(double thickness)
{
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(-1.0, 0.5);
  opacity->AddPoint(-0.4, 0.0);
  opacity->AddPoint(0.4, 0.0);
  opacity->AddPoint(0.6, 1.0 - 1e-12);
  opacity->AddPoint(1.0, 1.0 - 1e-12);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(-0.1, 1.0, 1.0, 1.0);
  color->AddRGBPoint(0.1, 0.0, 0.0, 0.0);
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  property->SetScalarOpacity(opacity);
  property->SetColor(color);
  property->SetScalarOpacityUnitDistance(thickness);
  property->SetInterpolationTypeToLinear();
  property->SetAmbient(0.0);
  property->SetDiffuse(1.0);
  return property;
}

}

ShadowScene MakeHalfPlane(double ratio, double width)
{
  const double thickness = Gap / (Layers - 11);
  ShadowScene scene;
  scene.Image = MakeSheets(thickness);
  scene.Property = MakeMedium(thickness);
  auto light = vtkSmartPointer<vtkAreaLight>::New();
  light->SetPosition(0.0, 0.0, Gap / ratio);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->PositionalOn();
  light->SetConeAngle(180.0);
  light->SetShapeToSquare();
  // The sheet is narrow along y. Light from a source that is wide along y would pass beside it.
  light->SetSize(width / ratio, 0.01 * width / ratio);
  scene.Lights = { light };
  scene.Camera = vtkSmartPointer<vtkCamera>::New();
  scene.Camera->ParallelProjectionOn();
  scene.Camera->SetPosition(0.0, 0.0, -4.0);
  scene.Camera->SetFocalPoint(0.0, 0.0, 0.0);
  scene.Camera->SetClippingRange(1.0, 10.0);
  // Pixels are square, and at most nine rows fit on the receiver.
  scene.Size = { { Pixels, 9 } };
  scene.Camera->SetParallelScale(0.5 * 9.0 * GetHalfPlanePixelWidth());
  return scene;
}

double GetHalfPlanePixelWidth()
{
  return VisibleFraction * Width / Pixels;
}

std::vector<double> GetPenumbra(const RgbaImage& rendered)
{
  std::vector<double> profile;
  for (int i = 0; i < rendered.Width; ++i)
  {
    profile.push_back(rendered.At(i, rendered.Height / 2)[0]);
  }
  // The camera looks up, so x may point to the left.
  if (profile.front() > profile.back())
  {
    std::reverse(profile.begin(), profile.end());
  }
  profile.erase(profile.begin(), profile.begin() + SkippedPixels);
  const double lit = profile.back();
  for (double& value : profile)
  {
    value /= lit;
  }
  return profile;
}

double GetRampWidth(const std::vector<double>& profile)
{
  double sum = 0.0;
  double first = 0.0;
  double second = 0.0;
  for (std::size_t i = 1; i < profile.size(); ++i)
  {
    const double slope = profile[i] - profile[i - 1];
    const double x = static_cast<double>(i) * GetHalfPlanePixelWidth();
    sum += slope;
    first += slope * x;
    second += slope * x * x;
  }
  const double mean = first / sum;
  return std::sqrt(12.0 * std::max(second / sum - mean * mean, 0.0));
}

double FitRampWidth(const std::vector<double>& profile)
{
  constexpr int Bits = 26;
  const double count = static_cast<double>(profile.size());
  // Returns the squared error of a ramp with the given center and width in pixels.
  const auto square = [&](double midpoint, double width)
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < profile.size(); ++i)
    {
      const double ramp =
        std::min(std::max((static_cast<double>(i) - midpoint) / width + 0.5, 0.0), 1.0);
      sum += (profile[i] - ramp) * (profile[i] - ramp);
    }
    return sum;
  };
  const auto minimumOfWidth = [&](double width)
  {
    return boost::math::tools::brent_find_minima(
      [&](double midpoint) { return square(midpoint, width); }, 0.0, count, Bits)
      .second;
  };
  return boost::math::tools::brent_find_minima(minimumOfWidth, 1.0, count, Bits).first *
    GetHalfPlanePixelWidth();
}

}

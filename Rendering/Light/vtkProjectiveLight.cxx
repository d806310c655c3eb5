// SPDX-License-Identifier: BSD-3-Clause
#include "vtkProjectiveLight.h"

#include "Common/NamedValue.h"
#include "Lights/LightFrame.h"
#include "Lights/LightImage.h"

#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkProjectiveLight);

namespace
{

constexpr double MinimumScreenSize = 1e-30;
constexpr double MaximumScreenSize = 1e30;

double SmoothStep(double distance, double width)
{
  if (distance >= width)
  {
    return 1.0;
  }
  const double t = distance / width;
  return t * t * (3.0 - 2.0 * t);
}

// Clamps a value; NaN becomes the lower limit.
double Clamp(double value, double lower, double upper)
{
  return value > lower ? std::min(value, upper) : lower;
}

}

vtkProjectiveLight::vtkProjectiveLight() = default;
vtkProjectiveLight::~vtkProjectiveLight() = default;

vtkCxxSetSmartPointerMacro(vtkProjectiveLight, Image, vtkImageData);

vtkImageData* vtkProjectiveLight::GetImage() const
{
  return this->Image;
}

void vtkProjectiveLight::SetScreenSize(double width, double height)
{
  if (std::isnan(width) || std::isnan(height))
  {
    return;
  }
  width = Clamp(width, MinimumScreenSize, MaximumScreenSize);
  height = Clamp(height, MinimumScreenSize, MaximumScreenSize);
  if (this->ScreenSize[0] != width || this->ScreenSize[1] != height)
  {
    this->ScreenSize[0] = width;
    this->ScreenSize[1] = height;
    this->Modified();
  }
}

void vtkProjectiveLight::SetViewUp(double x, double y, double z)
{
  if (interlume::LightFrame::SetViewUp(this->ViewUp, { x, y, z }))
  {
    this->Modified();
  }
}

void vtkProjectiveLight::SetEdgeWidth(double width)
{
  if (!std::isnan(width) && this->EdgeWidth != Clamp(width, 0.0, 1.0))
  {
    this->EdgeWidth = Clamp(width, 0.0, 1.0);
    this->Modified();
  }
}

void vtkProjectiveLight::SetScreenOpacity(double opacity)
{
  if (!std::isnan(opacity) && this->ScreenOpacity != Clamp(opacity, 0.0, 1.0))
  {
    this->ScreenOpacity = Clamp(opacity, 0.0, 1.0);
    this->Modified();
  }
}

bool vtkProjectiveLight::GetScreenMatrix(vtkMatrix4x4* matrix)
{
  double position[3];
  double focalPoint[3];
  double viewUp[3];
  this->GetTransformedPosition(position);
  this->GetTransformedFocalPoint(focalPoint);
  this->TransformVector(this->ViewUp, viewUp);
  return this->GetScreenMatrix(position, focalPoint, viewUp, 1.0, matrix);
}

bool vtkProjectiveLight::GetScreenMatrix(const double position[3], const double focalPoint[3],
  const double viewUp[3], double scale, vtkMatrix4x4* matrix) const
{
  interlume::LightFrame frame;
  if (!frame.Set(position, focalPoint, viewUp))
  {
    return false;
  }

  // The depth row yields 1 on the screen. The two other rows increase by 1 across the screen's
  // width and height, respectively.
  const glm::dvec3 depth = (1.0 / frame.Distance) * frame.Forward;
  const glm::dvec3 across[2] = { (1.0 / (scale * this->ScreenSize[0])) * frame.Right,
    (1.0 / (scale * this->ScreenSize[1])) * frame.Up };
  matrix->Zero();
  const auto setRow = [&](int row, const glm::dvec3& a, double constant)
  {
    for (int i = 0; i < 3; ++i)
    {
      matrix->SetElement(row, i, a[static_cast<std::size_t>(i)]);
    }
    matrix->SetElement(row, 3, constant - glm::dot(a, frame.Origin));
  };
  for (int i = 0; i < 2; ++i)
  {
    if (this->Positional)
    {
      setRow(i, across[i] + 0.5 * depth, 0.0);
    }
    else
    {
      setRow(i, across[i], 0.5);
    }
  }
  // Row 2 is unused. It only keeps the matrix invertible.
  const glm::dvec3 none{ 0.0, 0.0, 0.0 };
  setRow(this->Positional ? 3 : 2, depth, 0.0);
  setRow(this->Positional ? 2 : 3, none, 1.0);
  return std::all_of(
    matrix->GetData(), matrix->GetData() + 16, [](double value) { return std::isfinite(value); });
}

std::string vtkProjectiveLight::GetImageError() const
{
  return this->Image
    ? interlume::LightImage(this->Image).GetError("the image on its screen").GetMessage()
    : "";
}

std::vector<float> vtkProjectiveLight::GetTexels() const
{
  if (!this->Image || !this->GetImageError().empty())
  {
    return {};
  }
  return interlume::LightImage(this->Image).GetTexels();
}

void vtkProjectiveLight::GetScreenColor(double u, double v, double color[3]) const
{
  std::fill_n(color, 3, 0.0);
  const bool isInside = u >= 0.0 && u <= 1.0 && v >= 0.0 && v <= 1.0;
  if (!isInside || !this->GetImageError().empty())
  {
    return;
  }
  const double amount = this->ScreenOpacity *
    SmoothStep(std::min(u, 1.0 - u), 0.5 * this->EdgeWidth) *
    SmoothStep(std::min(v, 1.0 - v), 0.5 * this->EdgeWidth);
  const glm::dvec3 screenColor = this->Image
    ? interlume::LightImage(this->Image).GetColor(u, v, this->Interpolate)
    : glm::dvec3(1.0);
  std::copy_n(glm::value_ptr(amount * screenColor), 3, color);
}

vtkMTimeType vtkProjectiveLight::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->Image ? std::max(time, this->Image->GetMTime()) : time;
}

vtkLight* vtkProjectiveLight::ShallowClone()
{
  vtkProjectiveLight* clone = vtkProjectiveLight::New();
  clone->DeepCopy(this);
  clone->SetTransformMatrix(this->GetTransformMatrix());
  clone->SetShadowAttenuation(this->GetShadowAttenuation());
  clone->SetImage(this->Image);
  clone->SetInterpolate(this->Interpolate);
  clone->SetScreenSize(this->ScreenSize[0], this->ScreenSize[1]);
  clone->SetViewUp(this->ViewUp[0], this->ViewUp[1], this->ViewUp[2]);
  clone->SetEdgeWidth(this->EdgeWidth);
  clone->SetScreenOpacity(this->ScreenOpacity);
  return clone;
}

void vtkProjectiveLight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::NamedValue::Print(os, indent,
    { { "Image", this->Image.GetPointer() }, { "Interpolate", this->Interpolate ? "On" : "Off" },
      { "ScreenSize", this->ScreenSize }, { "ViewUp", this->ViewUp },
      { "EdgeWidth", this->EdgeWidth }, { "ScreenOpacity", this->ScreenOpacity } });
}

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkProjectiveLight.h"

#include "Space/UnitVector.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

vtkStandardNewMacro(vtkProjectiveLight);

namespace
{

constexpr double SmallestScreen = 1e-30;
constexpr double LargestScreen = 1e30;

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

void vtkProjectiveLight::SetImage(vtkImageData* image)
{
  if (this->Image != image)
  {
    this->Image = image;
    this->Modified();
  }
}

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
  width = Clamp(width, SmallestScreen, LargestScreen);
  height = Clamp(height, SmallestScreen, LargestScreen);
  if (this->ScreenSize[0] != width || this->ScreenSize[1] != height)
  {
    this->ScreenSize[0] = width;
    this->ScreenSize[1] = height;
    this->Modified();
  }
}

void vtkProjectiveLight::SetViewUp(double x, double y, double z)
{
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
  {
    return;
  }
  if (this->ViewUp[0] != x || this->ViewUp[1] != y || this->ViewUp[2] != z)
  {
    this->ViewUp[0] = x;
    this->ViewUp[1] = y;
    this->ViewUp[2] = z;
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
  using namespace interlume::UnitVector;
  const glm::dvec3 origin = glm::make_vec3(position);
  const glm::dvec3 axis = glm::make_vec3(focalPoint) - origin;
  const double distance = interlume::Vectors::SafeLength(axis);
  if (!(distance > 0.0) || !std::isfinite(distance))
  {
    return false;
  }
  const glm::dvec3 forward = Normalize(axis, axis);
  const glm::dvec3 up =
    Perpendicular(forward, Normalize(glm::make_vec3(viewUp), { 0.0, 1.0, 0.0 }));
  const glm::dvec3 right = glm::cross(forward, up);

  // Depth is 1 on the screen; across is 1 over its width or height.
  const glm::dvec3 depth = (1.0 / distance) * forward;
  const glm::dvec3 across[2] = { (1.0 / (scale * this->ScreenSize[0])) * right,
    (1.0 / (scale * this->ScreenSize[1])) * up };
  matrix->Zero();
  const auto setRow = [&](int row, const glm::dvec3& a, double constant)
  {
    for (int i = 0; i < 3; ++i)
    {
      matrix->SetElement(row, i, a[static_cast<std::size_t>(i)]);
    }
    matrix->SetElement(row, 3, constant - glm::dot(a, origin));
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
  // The third row is free and keeps the matrix regular.
  const glm::dvec3 none{ 0.0, 0.0, 0.0 };
  setRow(this->Positional ? 3 : 2, depth, 0.0);
  setRow(this->Positional ? 2 : 3, none, 1.0);
  return std::all_of(
    matrix->GetData(), matrix->GetData() + 16, [](double value) { return std::isfinite(value); });
}

std::string vtkProjectiveLight::GetImageError() const
{
  if (!this->Image)
  {
    return "";
  }
  int size[3];
  this->Image->GetDimensions(size);
  vtkDataArray* scalars = this->Image->GetPointData()->GetScalars();
  if (!scalars || scalars->GetNumberOfTuples() == 0)
  {
    return "the image on its screen has no samples";
  }
  if (size[2] != 1)
  {
    return "the image on its screen has " + std::to_string(size[2]) + " samples along z, not 1";
  }
  if (scalars->GetNumberOfTuples() != this->Image->GetNumberOfPoints())
  {
    return "the image on its screen has not one value for each of its points";
  }
  if (scalars->GetNumberOfComponents() > 4)
  {
    return "the image on its screen has " + std::to_string(scalars->GetNumberOfComponents()) +
      " components, not 1 to 4";
  }
  const int type = scalars->GetDataType();
  if (type != VTK_UNSIGNED_CHAR && type != VTK_FLOAT && type != VTK_DOUBLE)
  {
    return std::string("the image on its screen is of type ") + scalars->GetDataTypeAsString() +
      ", not unsigned char or floating point";
  }
  return "";
}

void vtkProjectiveLight::GetSample(vtkIdType index, double color[3]) const
{
  vtkDataArray* scalars = this->Image->GetPointData()->GetScalars();
  const double largest = scalars->GetDataType() == VTK_UNSIGNED_CHAR ? 255.0 : 1.0;
  const int components = scalars->GetNumberOfComponents();
  const auto value = [&](int component)
  { return Clamp(scalars->GetComponent(index, component) / largest, 0.0, 1.0); };
  const double opacity = components % 2 == 0 ? value(components - 1) : 1.0;
  for (int i = 0; i < 3; ++i)
  {
    color[i] = opacity * value(components > 2 ? i : 0);
  }
}

std::vector<float> vtkProjectiveLight::GetTexels() const
{
  std::vector<float> texels;
  if (this->Image && this->GetImageError().empty())
  {
    const vtkIdType samples = this->Image->GetNumberOfPoints();
    texels.reserve(3 * static_cast<std::size_t>(samples));
    for (vtkIdType i = 0; i < samples; ++i)
    {
      double color[3];
      this->GetSample(i, color);
      texels.insert(texels.end(), color, color + 3);
    }
  }
  return texels;
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
  if (!this->Image)
  {
    std::fill_n(color, 3, amount);
    return;
  }

  int size[3];
  this->Image->GetDimensions(size);
  const double place[2] = { u * size[0] - 0.5, v * size[1] - 0.5 };
  double lower[2];
  double weight[2];
  for (int axis = 0; axis < 2; ++axis)
  {
    lower[axis] = this->Interpolate ? std::floor(place[axis]) : std::floor(place[axis] + 0.5);
    weight[axis] = this->Interpolate ? place[axis] - lower[axis] : 0.0;
  }
  for (int corner = 0; corner < 4; ++corner)
  {
    const int steps[2] = { corner % 2, corner / 2 };
    double share = amount;
    vtkIdType index[2];
    for (int axis = 0; axis < 2; ++axis)
    {
      share *= steps[axis] ? weight[axis] : 1.0 - weight[axis];
      index[axis] = static_cast<vtkIdType>(Clamp(lower[axis] + steps[axis], 0.0, size[axis] - 1.0));
    }
    double sample[3];
    this->GetSample(index[1] * size[0] + index[0], sample);
    for (int i = 0; i < 3; ++i)
    {
      color[i] += share * sample[i];
    }
  }
}

vtkMTimeType vtkProjectiveLight::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Image ? std::max(own, this->Image->GetMTime()) : own;
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
  os << indent << "Image: " << this->Image.GetPointer() << "\n";
  os << indent << "Interpolate: " << (this->Interpolate ? "On" : "Off") << "\n";
  os << indent << "ScreenSize: " << this->ScreenSize[0] << " " << this->ScreenSize[1] << "\n";
  os << indent << "ViewUp: " << this->ViewUp[0] << " " << this->ViewUp[1] << " " << this->ViewUp[2]
     << "\n";
  os << indent << "EdgeWidth: " << this->EdgeWidth << "\n";
  os << indent << "ScreenOpacity: " << this->ScreenOpacity << "\n";
}

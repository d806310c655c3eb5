// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpatialImage.h"

#include "Common/ArrayCheck.h"
#include "Common/Error.h"
#include "Common/NamedValue.h"
#include "Sampling/PartPrinter.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkSpatialImage);

namespace
{
// Stored densities are clamped to this absolute value, so that interpolation of infinite scalars
// yields finite densities.
constexpr double LargestDensity = 1e30;

// A point is treated as inside the image if it is at most this far outside, in cells.
constexpr double SideTolerance = 1e-9;
}

vtkSpatialImage::vtkSpatialImage() = default;

vtkSpatialImage::~vtkSpatialImage() = default;

vtkCxxSetSmartPointerMacro(vtkSpatialImage, Image, vtkImageData);

vtkImageData* vtkSpatialImage::GetImage() const
{
  return this->Image;
}

void vtkSpatialImage::SetScalarRange(double a, double b)
{
  if (!std::isfinite(b - a) || a == b)
  {
    vtkErrorMacro("The scalar range " << a << " to " << b << " is empty or not finite. "
                                      << "Pass two different finite values.");
    return;
  }
  if (a != this->ScalarRange[0] || b != this->ScalarRange[1])
  {
    this->ScalarRange[0] = a;
    this->ScalarRange[1] = b;
    this->Modified();
  }
}

void vtkSpatialImage::SetColorArrayName(const char* name)
{
  const std::string given = name ? name : "";
  if (this->ColorArrayName != given)
  {
    this->ColorArrayName = given;
    this->Modified();
  }
}

vtkMTimeType vtkSpatialImage::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Image ? std::max(own, this->Image->GetMTime()) : own;
}

interlume::Error vtkSpatialImage::CopyValues()
{
  vtkDataArray* scalars = this->Image ? this->Image->GetPointData()->GetScalars() : nullptr;
  if (!scalars || scalars->GetNumberOfTuples() < 1)
  {
    return "A vtkSpatialImage has no image with point scalars. Call SetImage with an image that "
           "has active point scalars.";
  }
  const double scale = 1.0 / (this->ScalarRange[1] - this->ScalarRange[0]);
  this->Densities.resize(scalars->GetNumberOfTuples());
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    const double density = (scalars->GetComponent(i, 0) - this->ScalarRange[0]) * scale;
    this->Densities[i] = std::isnan(density)
      ? 0.0f
      : static_cast<float>(std::max(-LargestDensity, std::min(density, LargestDensity)));
  }
  return {};
}

interlume::Error vtkSpatialImage::CopyColors()
{
  this->Colors.clear();
  if (this->ColorArrayName.empty())
  {
    return {};
  }
  vtkDataArray* colors = this->Image->GetPointData()->GetArray(this->ColorArrayName.c_str());
  const bool hasMore = colors && colors->GetNumberOfComponents() > 3;
  if (const interlume::Error error = interlume::ArrayCheck::FindPointError(
        this->Image, "image", this->ColorArrayName, hasMore ? 0 : 3))
  {
    return interlume::ArrayCheck::MakeSentence(error);
  }
  const double scale = colors->GetDataType() == VTK_UNSIGNED_CHAR ? 1.0 / 255.0 : 1.0;
  for (vtkIdType i = 0; i < colors->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      const double color = scale * colors->GetComponent(i, c);
      this->Colors.push_back(static_cast<float>(vtkMath::ClampValue(color, 0.0, 1.0)));
    }
  }
  return {};
}

std::string vtkSpatialImage::Prepare(double bounds[6])
{
  const interlume::Error error = this->CopyValues().Then([this] { return this->CopyColors(); });
  if (!error)
  {
    this->Image->GetExtent(this->Extent);
    vtkMatrix4x4::DeepCopy(this->PhysicalToIndex, this->Image->GetPhysicalToIndexMatrix());
    this->Image->GetBounds(bounds);
  }
  return error.GetMessage();
}

bool vtkSpatialImage::Locate(const double x[3], vtkIdType corners[8], double weights[8]) const
{
  std::fill_n(corners, 8, 0);
  std::fill_n(weights, 8, 1.0);
  vtkIdType stride = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double* row = this->PhysicalToIndex + 4 * axis;
    const int last = this->Extent[2 * axis + 1] - this->Extent[2 * axis];
    const double position =
      row[0] * x[0] + row[1] * x[1] + row[2] * x[2] + row[3] - this->Extent[2 * axis];
    if (!(position >= -SideTolerance && position <= last + SideTolerance))
    {
      return false;
    }
    const int cell = std::max(0, std::min(static_cast<int>(position), last - 1));
    const double t = std::max(0.0, std::min(position - cell, 1.0));
    for (int corner = 0; corner < 8; ++corner)
    {
      const bool isUpper = (corner >> axis & 1) != 0;
      corners[corner] += stride * std::min(cell + (isUpper ? 1 : 0), last);
      weights[corner] *= isUpper ? t : 1.0 - t;
    }
    stride *= last + 1;
  }
  return true;
}

bool vtkSpatialImage::EvaluateLocally(const double (*points)[3], int number, Sample* samples) const
{
  bool isAny = false;
  for (int i = 0; i < number; ++i)
  {
    vtkIdType corners[8];
    double weights[8];
    samples[i] = Sample();
    if (!this->Locate(points[i], corners, weights))
    {
      continue;
    }
    double density = 0.0;
    double color[3] = { 0.0, 0.0, 0.0 };
    for (int corner = 0; corner < 8; ++corner)
    {
      density += weights[corner] * this->Densities[corners[corner]];
      for (int c = 0; c < 3 && !this->Colors.empty(); ++c)
      {
        color[c] += weights[corner] * this->Colors[3 * corners[corner] + c];
      }
    }
    samples[i].Density = this->GetDensity() * std::max(0.0, std::min(density, 1.0));
    std::copy_n(this->Colors.empty() ? this->GetLeafColor() : color, 3, samples[i].Color);
    isAny = isAny || samples[i].Density > 0.0;
  }
  return isAny;
}

void vtkSpatialImage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::NamedValue::Print(os, indent,
    { { "ScalarRange", this->ScalarRange }, { "ColorArrayName", this->ColorArrayName } });
  interlume::PartPrinter::Print(os, indent, "Image", this->Image);
}

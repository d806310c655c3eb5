// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpatialObject.h"

#include "Common/Error.h"
#include "Common/Vectors.h"
#include "Sampling/PartPrinter.h"

#include "vtkLinearTransform.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"

#include <algorithm>
#include <cmath>

namespace
{
// Enlargement of the bounds along an axis, relative to the larger of the bounds' absolute values.
constexpr double CullingTolerance = 1e-9;

constexpr double RotationTolerance = 1e-14;

// Minimum determinant of an invertible matrix, relative to the product of its column lengths.
constexpr double SingularTolerance = 1e-12;

// Returns the contribution of a side of a box to the bounds along an axis of the transformed box:
// the matrix element times the coordinate of the side. \a size is the largest absolute value in the
// matrix. An infinite side contributes nothing if \a element is so small that it is only the
// rounding error of a rotation by a right angle.
double GetReach(double element, double side, double size)
{
  const bool isNothing = std::isinf(side) && std::fabs(element) < RotationTolerance * size;
  return isNothing || element == 0.0 ? 0.0 : element * side;
}

void TransformPoint(const double rows[12], const double x[3], double y[3])
{
  for (int i = 0; i < 3; ++i)
  {
    const double* row = rows + 4 * i;
    y[i] = row[0] * x[0] + row[1] * x[1] + row[2] * x[2] + row[3];
  }
}
}

vtkSpatialObject::vtkSpatialObject() = default;

vtkSpatialObject::~vtkSpatialObject() = default;

vtkCxxSetSmartPointerMacro(vtkSpatialObject, Transform, vtkLinearTransform);

vtkLinearTransform* vtkSpatialObject::GetTransform() const
{
  return this->Transform;
}

vtkMTimeType vtkSpatialObject::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Transform ? std::max(own, this->Transform->GetMTime()) : own;
}

std::string vtkSpatialObject::Update()
{
  if (this->UpdateTime > this->GetMTime())
  {
    return "";
  }
  double matrix[12];
  if (!this->PrepareTransform(matrix))
  {
    return std::string("The transform of a ") + this->GetClassName() +
      " is not finite, has no inverse, or is not affine. Pass an invertible affine transform.";
  }
  double local[6];
  std::string error = this->Prepare(local);
  if (error.empty())
  {
    this->PrepareBounds(local, matrix);
    this->UpdateTime.Modified();
  }
  return error;
}

bool vtkSpatialObject::PrepareTransform(double matrix[12])
{
  double elements[16];
  vtkMatrix4x4::Identity(elements);
  if (this->Transform)
  {
    this->Transform->Update();
    vtkMatrix4x4::DeepCopy(elements, this->Transform->GetMatrix());
  }
  if (!std::all_of(elements, elements + 16, [](double e) { return std::isfinite(e); }) ||
    elements[12] != 0.0 || elements[13] != 0.0 || elements[14] != 0.0 || elements[15] != 1.0)
  {
    return false;
  }
  double lengths = 1.0;
  for (int j = 0; j < 3; ++j)
  {
    lengths *= glm::length(glm::dvec3(elements[j], elements[4 + j], elements[8 + j]));
  }
  if (!(std::fabs(vtkMatrix4x4::Determinant(elements)) > SingularTolerance * lengths))
  {
    return false;
  }
  double inverse[16];
  vtkMatrix4x4::Invert(elements, inverse);
  std::copy_n(elements, 12, matrix);
  std::copy_n(inverse, 12, this->Inverse);
  return std::all_of(inverse, inverse + 12, [](double e) { return std::isfinite(e); });
}

void vtkSpatialObject::PrepareBounds(const double local[6], const double matrix[12])
{
  const bool isEmpty = local[0] > local[1] || local[2] > local[3] || local[4] > local[5];
  double size = 0.0;
  for (int i = 0; i < 12; ++i)
  {
    size = i % 4 == 3 ? size : std::max(size, std::fabs(matrix[i]));
  }
  for (int i = 0; i < 3; ++i)
  {
    double& lower = this->Bounds[2 * i];
    double& upper = this->Bounds[2 * i + 1];
    lower = isEmpty ? vtkMath::Inf() : matrix[4 * i + 3];
    upper = isEmpty ? vtkMath::NegInf() : matrix[4 * i + 3];
    for (int j = 0; j < 3 && !isEmpty; ++j)
    {
      const double element = matrix[4 * i + j];
      lower += GetReach(element, local[2 * j + (element < 0.0 ? 1 : 0)], size);
      upper += GetReach(element, local[2 * j + (element < 0.0 ? 0 : 1)], size);
    }
    double margin = 0.0;
    for (double bound : { lower, upper })
    {
      margin =
        std::isfinite(bound) ? std::max(margin, CullingTolerance * std::fabs(bound)) : margin;
    }
    this->CullingBounds[2 * i] = lower - margin;
    this->CullingBounds[2 * i + 1] = upper + margin;
  }
}

bool vtkSpatialObject::GetBounds(double bounds[6])
{
  if (const interlume::Error error = this->Update())
  {
    vtkErrorMacro(<< error);
    return false;
  }
  std::copy_n(this->Bounds, 6, bounds);
  return true;
}

void vtkSpatialObject::Evaluate(const double x[3], Sample& sample)
{
  sample = Sample();
  if (const interlume::Error error = this->Update())
  {
    vtkErrorMacro(<< error);
    return;
  }
  const double points[1][3] = { { x[0], x[1], x[2] } };
  Sample found;
  if (this->EvaluateSpan(points, 1, &found) && found.Density > 0.0)
  {
    sample = found;
  }
}

bool vtkSpatialObject::Misses(const double (*points)[3], int number) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double lower = this->CullingBounds[2 * axis];
    const double upper = this->CullingBounds[2 * axis + 1];
    bool isBelow = true;
    bool isAbove = true;
    for (int i = 0; i < number && (isBelow || isAbove); ++i)
    {
      isBelow = isBelow && points[i][axis] < lower;
      isAbove = isAbove && points[i][axis] > upper;
    }
    if (isBelow || isAbove)
    {
      return true;
    }
  }
  return false;
}

bool vtkSpatialObject::EvaluateSpan(const double (*points)[3], int number, Sample* samples) const
{
  if (this->Misses(points, number))
  {
    return false;
  }
  if (!this->Transform)
  {
    return this->EvaluateLocally(points, number, samples);
  }
  double local[SpanLength][3];
  for (int i = 0; i < number; ++i)
  {
    TransformPoint(this->Inverse, points[i], local[i]);
  }
  return this->EvaluateLocally(local, number, samples);
}

void vtkSpatialObject::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::PartPrinter::Print(os, indent, "Transform", this->Transform);
}

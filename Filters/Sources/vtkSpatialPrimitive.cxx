// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpatialPrimitive.h"

#include "Common/NamedValue.h"
#include "Sampling/PartPrinter.h"

#include "vtkImplicitFunction.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkSpatialPrimitive);

namespace
{
double Hypotenuse(double x, double y)
{
  return std::sqrt(x * x + y * y);
}

// Returns the signed distance from a Cartesian product of intervals, given the signed distance from
// each interval.
template <int Size>
double GetProductDistance(const double (&distances)[Size])
{
  double outside = 0.0;
  double nearest = distances[0];
  for (double distance : distances)
  {
    nearest = std::max(nearest, distance);
    outside += distance > 0.0 ? distance * distance : 0.0;
  }
  return nearest > 0.0 ? std::sqrt(outside) : nearest;
}
}

vtkSpatialPrimitive::vtkSpatialPrimitive()
{
  for (int side = 0; side < 6; ++side)
  {
    this->Limits[side] = side % 2 == 0 ? vtkMath::NegInf() : vtkMath::Inf();
  }
}

vtkSpatialPrimitive::~vtkSpatialPrimitive() = default;

const char* vtkSpatialPrimitive::GetShapeName(int shape)
{
  static const char* const names[NUMBER_OF_SHAPES] = { "sphere", "box", "cylinder", "torus",
    "half-space", "fuzzy sphere", "implicit function" };
  return shape >= 0 && shape < NUMBER_OF_SHAPES ? names[shape] : nullptr;
}

void vtkSpatialPrimitive::SetCenter(double x, double y, double z)
{
  const double center[3] = { x, y, z };
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
  {
    vtkErrorMacro(
      "The center (" << x << ", " << y << ", " << z << ") is not finite and was ignored.");
    return;
  }
  if (!std::equal(center, center + 3, this->Center))
  {
    std::copy_n(center, 3, this->Center);
    this->Modified();
  }
}

void vtkSpatialPrimitive::SetSize(double& member, double size, const char* name, bool canBeZero)
{
  if (!(size > 0.0 || (canBeZero && size == 0.0)) || !std::isfinite(size))
  {
    vtkErrorMacro("The " << name << " must be finite and "
                         << (canBeZero ? "at least 0" : "greater than 0") << ", but is " << size
                         << ".");
    return;
  }
  if (member != size)
  {
    member = size;
    this->Modified();
  }
}

void vtkSpatialPrimitive::SetLengths(double x, double y, double z)
{
  const double lengths[3] = { x, y, z };
  if (!std::all_of(lengths, lengths + 3, [](double l) { return l > 0.0 && std::isfinite(l); }))
  {
    vtkErrorMacro(
      "The lengths (" << x << ", " << y << ", " << z << ") must be finite and greater than 0.");
    return;
  }
  if (!std::equal(lengths, lengths + 3, this->Lengths))
  {
    std::copy_n(lengths, 3, this->Lengths);
    this->Modified();
  }
}

vtkCxxSetSmartPointerMacro(vtkSpatialPrimitive, Function, vtkImplicitFunction);

vtkImplicitFunction* vtkSpatialPrimitive::GetFunction() const
{
  return this->Function;
}

void vtkSpatialPrimitive::SetLimits(const double limits[6])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(limits[2 * axis] <= limits[2 * axis + 1]))
    {
      vtkErrorMacro("The limits " << limits[2 * axis] << " and " << limits[2 * axis + 1]
                                  << " along axis " << axis << " are not in ascending order.");
      return;
    }
  }
  if (!std::equal(limits, limits + 6, this->Limits))
  {
    std::copy_n(limits, 6, this->Limits);
    this->Modified();
  }
}

vtkMTimeType vtkSpatialPrimitive::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Function ? std::max(own, this->Function->GetMTime()) : own;
}

std::string vtkSpatialPrimitive::Prepare(double bounds[6])
{
  if (this->Shape == FUZZY_SPHERE && !(this->InnerRadius < this->Radius))
  {
    return "The inner radius of a fuzzy sphere is not less than its radius. Reduce InnerRadius or "
           "increase Radius.";
  }
  if (this->Shape == IMPLICIT_FUNCTION)
  {
    std::copy_n(this->Limits, 6, bounds);
    return this->Function ? ""
                          : "A vtkSpatialPrimitive with an implicit function has no function. "
                            "Call SetFunction.";
  }
  double half[3] = { this->Radius, this->Radius, this->Radius };
  switch (this->Shape)
  {
    case BOX:
      std::transform(this->Lengths, this->Lengths + 3, half, [](double l) { return 0.5 * l; });
      break;
    case CYLINDER:
      half[2] = 0.5 * this->Height;
      break;
    case TORUS:
      half[0] = half[1] = this->Radius + this->TubeRadius;
      half[2] = this->TubeRadius;
      break;
    case HALF_SPACE:
      half[0] = half[1] = vtkMath::Inf();
      half[2] = 0.0;
      break;
    default:
      break;
  }
  const double edge = this->Shape == FUZZY_SPHERE ? 0.0 : 0.5 * this->EdgeWidth;
  for (int axis = 0; axis < 3; ++axis)
  {
    bounds[2 * axis] = this->Center[axis] - half[axis] - edge;
    bounds[2 * axis + 1] = this->Center[axis] + half[axis] + edge;
  }
  if (this->Shape == HALF_SPACE)
  {
    bounds[4] = vtkMath::NegInf();
  }
  return "";
}

double vtkSpatialPrimitive::GetProfile(const double x[3]) const
{
  const double p[3] = { x[0] - this->Center[0], x[1] - this->Center[1], x[2] - this->Center[2] };
  switch (this->Shape)
  {
    case SPHERE:
      return this->GetEdgeProfile(vtkMath::Norm(p) - this->Radius);
    case BOX:
      return this->GetEdgeProfile(GetProductDistance({ std::fabs(p[0]) - 0.5 * this->Lengths[0],
        std::fabs(p[1]) - 0.5 * this->Lengths[1], std::fabs(p[2]) - 0.5 * this->Lengths[2] }));
    case CYLINDER:
      return this->GetEdgeProfile(GetProductDistance(
        { Hypotenuse(p[0], p[1]) - this->Radius, std::fabs(p[2]) - 0.5 * this->Height }));
    case TORUS:
      return this->GetEdgeProfile(
        Hypotenuse(Hypotenuse(p[0], p[1]) - this->Radius, p[2]) - this->TubeRadius);
    case HALF_SPACE:
      return this->GetEdgeProfile(p[2]);
    case IMPLICIT_FUNCTION:
      return this->GetProfileOfFunction(x);
    default:
    {
      const double r0 = this->Radius * this->Radius;
      const double r1 = this->InnerRadius * this->InnerRadius;
      const double density = (r0 - vtkMath::Dot(p, p)) / (r0 - r1);
      return std::max(0.0, std::min(density, 1.0));
    }
  }
}

double vtkSpatialPrimitive::GetProfileOfFunction(const double x[3]) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (x[axis] < this->Limits[2 * axis] || x[axis] > this->Limits[2 * axis + 1])
    {
      return 0.0;
    }
  }
  const double value = this->Function->FunctionValue(x);
  if (this->EdgeWidth == 0.0)
  {
    return this->GetEdgeProfile(value);
  }
  double gradient[3];
  double position[3] = { x[0], x[1], x[2] };
  this->Function->FunctionGradient(position, gradient);
  const double steepness = vtkMath::Norm(gradient);
  // Without a gradient, only the sign of the distance is available.
  return this->GetEdgeProfile(
    steepness > 0.0 ? value / steepness : std::copysign(this->EdgeWidth, value));
}

double vtkSpatialPrimitive::GetEdgeProfile(double distance) const
{
  const double half = 0.5 * this->EdgeWidth;
  if (distance <= -half)
  {
    return 1.0;
  }
  if (!(distance < half))
  {
    return 0.0;
  }
  const double e = 0.5 - distance / this->EdgeWidth;
  return e * e * (3.0 - 2.0 * e);
}

bool vtkSpatialPrimitive::EvaluateLocally(
  const double (*points)[3], int number, Sample* samples) const
{
  bool isAny = false;
  for (int i = 0; i < number; ++i)
  {
    samples[i].Density = this->GetDensity() * this->GetProfile(points[i]);
    std::copy_n(this->GetLeafColor(), 3, samples[i].Color);
    isAny = isAny || samples[i].Density > 0.0;
  }
  return isAny;
}

void vtkSpatialPrimitive::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::NamedValue::Print(os, indent,
    { { "Shape", GetShapeName(this->Shape) }, { "EdgeWidth", this->EdgeWidth },
      { "Center", this->Center }, { "Radius", this->Radius }, { "InnerRadius", this->InnerRadius },
      { "TubeRadius", this->TubeRadius }, { "Height", this->Height }, { "Lengths", this->Lengths },
      { "Limits", this->Limits } });
  interlume::PartPrinter::Print(os, indent, "Function", this->Function);
}

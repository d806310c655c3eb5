// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpatialPrimitive.h"

#include "Common/NamedValue.h"

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

// Returns the signed distance from a product of intervals, from the signed distances from each of
// them.
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

const char* vtkSpatialPrimitive::GetShapeName(int shape)
{
  static const char* const names[NUMBER_OF_SHAPES] = { "sphere", "box", "cylinder", "torus",
    "half-space", "fuzzy sphere" };
  return shape >= 0 && shape < NUMBER_OF_SHAPES ? names[shape] : nullptr;
}

void vtkSpatialPrimitive::SetCenter(double x, double y, double z)
{
  const double center[3] = { x, y, z };
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
  {
    vtkErrorMacro("The centre " << x << " " << y << " " << z << " is not finite.");
    return;
  }
  if (!std::equal(center, center + 3, this->Center))
  {
    std::copy_n(center, 3, this->Center);
    this->Modified();
  }
}

void vtkSpatialPrimitive::SetSize(double& member, double size, const char* name)
{
  if (!(size > 0.0) || !std::isfinite(size))
  {
    vtkErrorMacro("The " << name << " " << size << " is not finite or not above 0.");
    return;
  }
  if (member != size)
  {
    member = size;
    this->Modified();
  }
}

void vtkSpatialPrimitive::SetInnerRadius(double radius)
{
  if (!(radius >= 0.0) || !std::isfinite(radius))
  {
    vtkErrorMacro("The inner radius " << radius << " is not finite or below 0.");
    return;
  }
  if (this->InnerRadius != radius)
  {
    this->InnerRadius = radius;
    this->Modified();
  }
}

void vtkSpatialPrimitive::SetLengths(double x, double y, double z)
{
  const double lengths[3] = { x, y, z };
  if (!std::all_of(lengths, lengths + 3, [](double l) { return l > 0.0 && std::isfinite(l); }))
  {
    vtkErrorMacro(
      "The lengths " << x << " " << y << " " << z << " are not all finite and above 0.");
    return;
  }
  if (!std::equal(lengths, lengths + 3, this->Lengths))
  {
    std::copy_n(lengths, 3, this->Lengths);
    this->Modified();
  }
}

std::string vtkSpatialPrimitive::Prepare(double bounds[6])
{
  if (this->Shape == FUZZY_SPHERE && !(this->InnerRadius < this->Radius))
  {
    return "The inner radius of a fuzzy sphere is not below its radius.";
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
  const double edge = this->Shape == FUZZY_SPHERE ? 0.0 : 0.5 * this->GetEdgeWidth();
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
    default:
    {
      const double r0 = this->Radius * this->Radius;
      const double r1 = this->InnerRadius * this->InnerRadius;
      const double density = (r0 - vtkMath::Dot(p, p)) / (r0 - r1);
      return std::max(0.0, std::min(density, 1.0));
    }
  }
}

void vtkSpatialPrimitive::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::NamedValue::Print(os, indent,
    { { "Shape", GetShapeName(this->Shape) }, { "Center", this->Center },
      { "Radius", this->Radius }, { "InnerRadius", this->InnerRadius },
      { "TubeRadius", this->TubeRadius }, { "Height", this->Height },
      { "Lengths", this->Lengths } });
}

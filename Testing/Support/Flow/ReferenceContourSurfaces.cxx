// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Flow/ReferenceContourSurfaces.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

namespace reference
{

vtkStandardNewMacro(Plane);
vtkStandardNewMacro(Cylinder);

void Plane::SetSize(double u, double v)
{
  this->Size[0] = u;
  this->Size[1] = v;
  this->Modified();
}

std::string Plane::Update()
{
  return this->Size[0] > 0.0 && this->Size[1] > 0.0 ? "" : "Plane: both sizes must be positive.";
}

double Plane::EvaluateDistance(const double x[3]) const
{
  return x[0];
}

void Plane::EvaluateParameters(const double x[3], double uv[2]) const
{
  uv[0] = x[1] / this->Size[0];
  uv[1] = x[2] / this->Size[1];
}

void Plane::EvaluateNormal(const double*, double normal[3]) const
{
  normal[0] = 1.0;
  normal[1] = normal[2] = 0.0;
}

bool Plane::EvaluatePoint(int, const double uv[2], double x[3]) const
{
  x[0] = 0.0;
  x[1] = uv[0] * this->Size[0];
  x[2] = uv[1] * this->Size[1];
  return uv[0] >= 0.0 && uv[0] <= 1.0 && uv[1] >= 0.0 && uv[1] <= 1.0;
}

void Plane::GetBounds(double bounds[6]) const
{
  const double own[6] = { 0.0, 0.0, 0.0, this->Size[0], 0.0, this->Size[1] };
  std::copy_n(own, 6, bounds);
}

void Cylinder::SetRadius(double radius)
{
  this->Radius = radius;
  this->Modified();
}

void Cylinder::SetGap(double from, double to)
{
  this->Gap[0] = from;
  this->Gap[1] = to;
  this->Modified();
}

double Cylinder::EvaluateDistance(const double x[3]) const
{
  return std::hypot(x[0], x[1]) - this->Radius;
}

void Cylinder::EvaluateParameters(const double x[3], double uv[2]) const
{
  const double turns = std::atan2(x[1], x[0]) / (2.0 * vtkMath::Pi());
  uv[0] = turns - std::floor(turns);
  uv[1] = x[2];
}

void Cylinder::EvaluateNormal(const double x[3], double normal[3]) const
{
  const double length = std::hypot(x[0], x[1]);
  normal[0] = x[0] / length;
  normal[1] = x[1] / length;
  normal[2] = 0.0;
}

bool Cylinder::EvaluatePoint(int, const double uv[2], double x[3]) const
{
  const double angle = 2.0 * vtkMath::Pi() * uv[0];
  x[0] = this->Radius * std::cos(angle);
  x[1] = this->Radius * std::sin(angle);
  x[2] = uv[1];
  return uv[0] >= 0.0 && uv[0] <= 1.0 && uv[1] >= 0.0 && uv[1] <= 1.0 &&
    !(uv[0] > this->Gap[0] && uv[0] < this->Gap[1]);
}

void Cylinder::GetBounds(double bounds[6]) const
{
  const double r = this->Radius;
  const double own[6] = { -r, r, -r, r, 0.0, 1.0 };
  std::copy_n(own, 6, bounds);
}

}

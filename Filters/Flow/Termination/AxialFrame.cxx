// SPDX-License-Identifier: BSD-3-Clause
#include "Termination/AxialFrame.h"

#include "Common/Vectors.h"

#include "vtkMath.h"

#include <cmath>

namespace interlume
{

void AxialFrame::SetAxis(const glm::dvec3& axis)
{
  const double length = Vectors::SafeLength(axis);
  const glm::dvec3 a = length > 0.0 ? axis / length : axis;
  const double sign = std::copysign(1.0, a.z);
  const double scale = -1.0 / (sign + a.z);
  this->SetAxis(a, { 1.0 + sign * a.x * a.x * scale, sign * a.x * a.y * scale, -sign * a.x });
}

void AxialFrame::SetAxis(const glm::dvec3& axis, const glm::dvec3& x)
{
  this->Axis = axis;
  this->X = x;
  this->Y = glm::cross(this->Axis, this->X);
}

glm::dvec3 AxialFrame::GetComponents(const glm::dvec3& x, const glm::dvec3& origin) const
{
  const glm::dvec3 p = x - origin;
  return { glm::dot(p, this->X), glm::dot(p, this->Y), glm::dot(p, this->Axis) };
}

glm::dvec3 AxialFrame::GetVector(double a, double b, double c) const
{
  return a * this->X + b * this->Y + c * this->Axis;
}

double AxialFrame::GetAngleInTurns(double x, double y)
{
  const double turn = std::atan2(y, x) / (2.0 * vtkMath::Pi());
  const double positive = turn < 0.0 ? turn + 1.0 : turn;
  return positive < 1.0 ? positive : 0.0;
}

}

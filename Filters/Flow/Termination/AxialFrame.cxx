// SPDX-License-Identifier: BSD-3-Clause
#include "Termination/AxialFrame.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

void AxialFrame::SetAxis(const double axis[3])
{
  double a[3] = { axis[0], axis[1], axis[2] };
  vtkMath::Normalize(a);
  const double sign = std::copysign(1.0, a[2]);
  const double scale = -1.0 / (sign + a[2]);
  const double x[3] = { 1.0 + sign * a[0] * a[0] * scale, sign * a[0] * a[1] * scale,
    -sign * a[0] };
  this->SetAxis(a, x);
}

void AxialFrame::SetAxis(const double axis[3], const double x[3])
{
  std::copy_n(axis, 3, this->Axis);
  std::copy_n(x, 3, this->X);
  vtkMath::Cross(this->Axis, this->X, this->Y);
}

void AxialFrame::GetComponents(
  const double x[3], const double origin[3], double components[3]) const
{
  const double p[3] = { x[0] - origin[0], x[1] - origin[1], x[2] - origin[2] };
  components[0] = vtkMath::Dot(p, this->X);
  components[1] = vtkMath::Dot(p, this->Y);
  components[2] = vtkMath::Dot(p, this->Axis);
}

void AxialFrame::GetPoint(const double origin[3], double a, double b, double c, double x[3]) const
{
  for (int i = 0; i < 3; ++i)
  {
    x[i] = origin[i] + (a * this->X[i] + b * this->Y[i] + c * this->Axis[i]);
  }
}

double AxialFrame::GetTurn(double x, double y)
{
  const double turn = std::atan2(y, x) / (2.0 * vtkMath::Pi());
  const double positive = turn < 0.0 ? turn + 1.0 : turn;
  return positive < 1.0 ? positive : 0.0;
}

}

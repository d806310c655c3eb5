// SPDX-License-Identifier: BSD-3-Clause
#include "Termination/ClosestTrianglePoint.h"

#include "vtkMath.h"

namespace interlume
{

namespace
{
struct Choice
{
  int Feature;
  double Weights[3];
};

Choice Choose(const double x[3], const double a[3], const double b[3], const double c[3])
{
  double ab[3];
  double ac[3];
  double p[3];
  vtkMath::Subtract(b, a, ab);
  vtkMath::Subtract(c, a, ac);
  vtkMath::Subtract(x, a, p);
  const double abA = vtkMath::Dot(ab, p);
  const double acA = vtkMath::Dot(ac, p);
  if (abA <= 0.0 && acA <= 0.0)
  {
    return { ClosestTrianglePoint::FIRST_CORNER, { 1.0, 0.0, 0.0 } };
  }
  vtkMath::Subtract(x, b, p);
  const double abB = vtkMath::Dot(ab, p);
  const double acB = vtkMath::Dot(ac, p);
  if (abB >= 0.0 && acB <= abB)
  {
    return { ClosestTrianglePoint::FIRST_CORNER + 1, { 0.0, 1.0, 0.0 } };
  }
  const double areaC = abA * acB - abB * acA;
  if (areaC <= 0.0 && abA >= 0.0 && abB <= 0.0)
  {
    const double t = abA / (abA - abB);
    return { ClosestTrianglePoint::FIRST_EDGE, { 1.0 - t, t, 0.0 } };
  }
  vtkMath::Subtract(x, c, p);
  const double abC = vtkMath::Dot(ab, p);
  const double acC = vtkMath::Dot(ac, p);
  if (acC >= 0.0 && abC <= acC)
  {
    return { ClosestTrianglePoint::FIRST_CORNER + 2, { 0.0, 0.0, 1.0 } };
  }
  const double areaB = abC * acA - abA * acC;
  if (areaB <= 0.0 && acA >= 0.0 && acC <= 0.0)
  {
    const double t = acA / (acA - acC);
    return { ClosestTrianglePoint::FIRST_EDGE + 2, { 1.0 - t, 0.0, t } };
  }
  const double areaA = abB * acC - abC * acB;
  const double fromB = acB - abB;
  const double fromC = abC - acC;
  if (areaA <= 0.0 && fromB >= 0.0 && fromC >= 0.0)
  {
    const double t = fromB / (fromB + fromC);
    return { ClosestTrianglePoint::FIRST_EDGE + 1, { 0.0, 1.0 - t, t } };
  }
  const double area = areaA + areaB + areaC;
  return { ClosestTrianglePoint::FACE, { areaA / area, areaB / area, areaC / area } };
}
}

ClosestTrianglePoint::ClosestTrianglePoint(
  const double x[3], const double a[3], const double b[3], const double c[3])
{
  const Choice choice = Choose(x, a, b, c);
  this->Feature = choice.Feature;
  for (int i = 0; i < 3; ++i)
  {
    this->Weights[i] = choice.Weights[i];
  }
  for (int i = 0; i < 3; ++i)
  {
    // The point is computed from a, so that the rounding is that of the triangle's size.
    this->Point[i] = a[i] + choice.Weights[1] * (b[i] - a[i]) + choice.Weights[2] * (c[i] - a[i]);
  }
  this->SquaredDistance = vtkMath::Distance2BetweenPoints(x, this->Point);
}

}

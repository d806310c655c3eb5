// SPDX-License-Identifier: BSD-3-Clause
#include "Termination/ClosestTrianglePoint.h"

#include <glm/geometric.hpp>

namespace interlume
{

namespace
{
struct Choice
{
  int Feature;
  glm::dvec3 Weights;
};

Choice Choose(const glm::dvec3& x, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
  const glm::dvec3 ab = b - a;
  const glm::dvec3 ac = c - a;
  const double abA = glm::dot(ab, x - a);
  const double acA = glm::dot(ac, x - a);
  if (abA <= 0.0 && acA <= 0.0)
  {
    return { ClosestTrianglePoint::FIRST_CORNER, { 1.0, 0.0, 0.0 } };
  }
  const double abB = glm::dot(ab, x - b);
  const double acB = glm::dot(ac, x - b);
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
  const double abC = glm::dot(ab, x - c);
  const double acC = glm::dot(ac, x - c);
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
  const glm::dvec3& x, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
  const Choice choice = Choose(x, a, b, c);
  this->Feature = choice.Feature;
  this->Weights = choice.Weights;
  // Start from a so that the rounding error is relative to the size of the triangle.
  this->Point = a + choice.Weights[1] * (b - a) + choice.Weights[2] * (c - a);
  const glm::dvec3 difference = x - this->Point;
  this->SquaredDistance = glm::dot(difference, difference);
}

}

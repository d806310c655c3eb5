// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Images/ReferenceTetrahedron.h"

#include <algorithm>
#include <cmath>

namespace reference
{

namespace
{

Vector Difference(const Vector& a, const Vector& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

Vector Cross(const Vector& a, const Vector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

}

RayTetrahedron::RayTetrahedron(const std::array<Vector, 4>& corners)
  : Corners(corners)
  , Gradients()
  , Valid(true)
{
  for (int i = 0; i < 4; ++i)
  {
    // Barycentric coordinate i is 0 on the face opposite corner i and 1 at corner i.
    const Vector& a = corners[(i + 1) % 4];
    const Vector normal =
      Cross(Difference(corners[(i + 2) % 4], a), Difference(corners[(i + 3) % 4], a));
    const Real height = Dot(normal, Difference(corners[i], a));
    this->Valid = this->Valid && std::isfinite(height) && height != 0;
    for (int k = 0; k < 3; ++k)
    {
      this->Gradients[i][k] = normal[k] / height;
    }
  }
}

std::optional<Segment> RayTetrahedron::Meet(const Ray& ray, Real from, Real to) const
{
  // Distances are measured from the point on the ray closest to corner 0.
  const Real center = Dot(ray.Direction, Difference(this->Corners[0], ray.Origin));
  Vector point;
  for (int k = 0; k < 3; ++k)
  {
    point[k] = ray.Origin[k] + center * ray.Direction[k];
  }
  Barycentric value;
  Barycentric slope;
  Real entry = from - center;
  Real exit = to - center;
  for (int i = 0; i < 4; ++i)
  {
    value[i] = Dot(this->Gradients[i], Difference(point, this->Corners[(i + 1) % 4]));
    slope[i] = Dot(this->Gradients[i], ray.Direction);
    if (slope[i] > 0)
    {
      entry = std::max(entry, -value[i] / slope[i]);
    }
    else if (slope[i] < 0)
    {
      exit = std::min(exit, -value[i] / slope[i]);
    }
    else if (value[i] < 0)
    {
      return std::nullopt;
    }
  }
  if (!(entry < exit))
  {
    return std::nullopt;
  }
  Segment segment = { center + entry, center + exit, {}, {} };
  for (int i = 0; i < 4; ++i)
  {
    segment.AtEntry[i] = value[i] + entry * slope[i];
    segment.AtExit[i] = value[i] + exit * slope[i];
  }
  return segment;
}

}

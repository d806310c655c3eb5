// SPDX-License-Identifier: BSD-3-Clause
#include "Plan/SliceNormal.h"

#include "Common/Vectors.h"

#include <limits>

namespace interlume
{

namespace
{

using namespace UnitVector;

// Distance between the origin and the hull below which the hull is treated as containing the
// origin.
constexpr double MinimumLength = 1e-6;

// The point of a simplex that is closest to the origin, and the vertices of the face that contains
// it.
struct ClosestPoint
{
  glm::dvec3 Point{ 0.0, 0.0, 0.0 };
  std::vector<glm::dvec3> Corners;
};

// Projects the origin onto the plane, line or point through all vertices. Returns false if the
// projection is not inside the simplex.
bool Project(const std::vector<glm::dvec3>& corners, glm::dvec3& point)
{
  const glm::dvec3& a = corners[0];
  if (corners.size() == 1)
  {
    point = a;
    return true;
  }
  const glm::dvec3 u = corners[1] - a;
  if (corners.size() == 2)
  {
    const double t = -glm::dot(a, u) / glm::dot(u, u);
    point = a + t * u;
    return t > 0.0 && t < 1.0;
  }
  const glm::dvec3 v = corners[2] - a;
  const double determinant = glm::dot(u, u) * glm::dot(v, v) - glm::dot(u, v) * glm::dot(u, v);
  const double s =
    (glm::dot(u, v) * glm::dot(a, v) - glm::dot(v, v) * glm::dot(a, u)) / determinant;
  const double t =
    (glm::dot(u, v) * glm::dot(a, u) - glm::dot(u, u) * glm::dot(a, v)) / determinant;
  point = a + s * u + t * v;
  return s > 0.0 && t > 0.0 && s + t < 1.0;
}

bool ContainsOrigin(const std::vector<glm::dvec3>& corners)
{
  // The origin has to be on the inner side of each face.
  for (std::size_t i = 0; i < 4; ++i)
  {
    const glm::dvec3& a = corners[(i + 1) % 4];
    const glm::dvec3 normal = glm::cross(corners[(i + 2) % 4] - a, corners[(i + 3) % 4] - a);
    const double inside = glm::dot(normal, corners[i] - a);
    if (!(inside * -glm::dot(normal, a) > 0.0))
    {
      return false;
    }
  }
  return true;
}

ClosestPoint FindClosest(const std::vector<glm::dvec3>& corners)
{
  ClosestPoint closest;
  if (corners.size() == 4 && ContainsOrigin(corners))
  {
    return closest;
  }
  double minimum = std::numeric_limits<double>::max();
  const unsigned all = (1u << corners.size()) - 1;
  for (unsigned subset = 1; subset <= all; ++subset)
  {
    std::vector<glm::dvec3> face;
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      if (subset >> i & 1u)
      {
        face.push_back(corners[i]);
      }
    }
    glm::dvec3 point;
    if (face.size() < 4 && Project(face, point) && glm::dot(point, point) < minimum)
    {
      minimum = glm::dot(point, point);
      closest.Point = point;
      closest.Corners = face;
    }
  }
  return closest;
}

}

void SliceNormal::Add(const glm::dvec3& ray, double cosine)
{
  this->Rays.push_back((1.0 / cosine) * ray);
}

void SliceNormal::Add(const std::vector<glm::dvec3>& rays, double sign, double cosine)
{
  for (const glm::dvec3& ray : rays)
  {
    this->Add(ray, sign * cosine);
  }
}

double SliceNormal::GetRatio(const glm::dvec3& normal) const
{
  double ratio = std::numeric_limits<double>::max();
  for (const glm::dvec3& ray : this->Rays)
  {
    ratio = std::min(ratio, glm::dot(ray, normal));
  }
  return ratio;
}

double SliceNormal::FindBest()
{
  // This is the algorithm of Gilbert, Johnson and Keerthi (GJK). Each step moves to a simplex of
  // the hull that is closer to the origin.
  this->BestRatio = 0.0;
  if (this->Rays.empty())
  {
    return 0.0;
  }
  ClosestPoint closest;
  closest.Corners = { this->Rays.front() };
  closest.Point = this->Rays.front();
  constexpr int maximumSteps = 100;
  constexpr double tolerance = 1e-13;
  for (int step = 0; step < maximumSteps && Vectors::SafeLength(closest.Point) > MinimumLength;
       ++step)
  {
    const auto support = std::min_element(this->Rays.begin(), this->Rays.end(),
      [&](const glm::dvec3& a, const glm::dvec3& b)
      { return glm::dot(a, closest.Point) < glm::dot(b, closest.Point); });
    const double squared = glm::dot(closest.Point, closest.Point);
    if (glm::dot(*support, closest.Point) >= squared * (1.0 - tolerance))
    {
      break;
    }
    std::vector<glm::dvec3> corners = closest.Corners;
    corners.push_back(*support);
    const ClosestPoint next = FindClosest(corners);
    if (!(glm::dot(next.Point, next.Point) < squared))
    {
      break;
    }
    closest = next;
  }
  const double length = Vectors::SafeLength(closest.Point);
  if (length > MinimumLength)
  {
    this->Best = Normalize(closest.Point, closest.Point);
    this->BestRatio = std::max(this->GetRatio(this->Best), 0.0);
  }
  return this->BestRatio;
}

glm::dvec3 SliceNormal::Adjust(const glm::dvec3& preferred) const
{
  if (!(this->BestRatio > 0.0) || this->GetRatio(preferred) >= 1.0)
  {
    return preferred;
  }
  if (this->BestRatio <= 1.0)
  {
    return this->Best;
  }
  // On the chord from preferred to the best normal, min d_k.x / c_k - |x| is concave and changes
  // sign once, so bisection finds the rotation.
  double bad = 0.0;
  double good = 1.0;
  glm::dvec3 normal = this->Best;
  constexpr int halvings = 50;
  for (int i = 0; i < halvings; ++i)
  {
    const double midpoint = 0.5 * (bad + good);
    const glm::dvec3 rotated =
      Normalize((1.0 - midpoint) * preferred + midpoint * this->Best, this->Best);
    if (this->GetRatio(rotated) >= 1.0)
    {
      good = midpoint;
      normal = rotated;
    }
    else
    {
      bad = midpoint;
    }
  }
  return normal;
}

}

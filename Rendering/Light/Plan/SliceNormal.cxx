// SPDX-License-Identifier: BSD-3-Clause
#include "Plan/SliceNormal.h"

#include "Common/Vectors.h"

#include <limits>

namespace interlume
{

namespace
{

using namespace UnitVector;

// The length below which the hull of rays holds 0 as far as rounding tells.
constexpr double Smallest = 1e-6;

// The point of a simplex nearest to 0, and its corners that the point is between.
struct Nearest
{
  glm::dvec3 Point{ 0.0, 0.0, 0.0 };
  std::vector<glm::dvec3> Corners;
};

// Of the plane, line or point through all corners; false where it is not between them.
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

bool HoldsZero(const std::vector<glm::dvec3>& corners)
{
  // The foot has to be on the inner side of each face.
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

Nearest FindNearest(const std::vector<glm::dvec3>& corners)
{
  Nearest nearest;
  if (corners.size() == 4 && HoldsZero(corners))
  {
    return nearest;
  }
  double least = std::numeric_limits<double>::max();
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
    if (face.size() < 4 && Project(face, point) && glm::dot(point, point) < least)
    {
      least = glm::dot(point, point);
      nearest.Point = point;
      nearest.Corners = face;
    }
  }
  return nearest;
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
  // The method of Gilbert, Johnson and Keerthi goes from simplex to simplex of the hull, always
  // nearer to 0.
  this->BestRatio = 0.0;
  if (this->Rays.empty())
  {
    return 0.0;
  }
  Nearest nearest;
  nearest.Corners = { this->Rays.front() };
  nearest.Point = this->Rays.front();
  constexpr int most = 100;
  constexpr double tolerance = 1e-13;
  for (int step = 0; step < most && Vectors::SafeLength(nearest.Point) > Smallest; ++step)
  {
    const auto next = std::min_element(this->Rays.begin(), this->Rays.end(),
      [&](const glm::dvec3& a, const glm::dvec3& b)
      { return glm::dot(a, nearest.Point) < glm::dot(b, nearest.Point); });
    const double squared = glm::dot(nearest.Point, nearest.Point);
    if (glm::dot(*next, nearest.Point) >= squared * (1.0 - tolerance))
    {
      break;
    }
    std::vector<glm::dvec3> corners = nearest.Corners;
    corners.push_back(*next);
    const Nearest nearer = FindNearest(corners);
    if (!(glm::dot(nearer.Point, nearer.Point) < squared))
    {
      break;
    }
    nearest = nearer;
  }
  const double length = Vectors::SafeLength(nearest.Point);
  if (length > Smallest)
  {
    this->Best = Normalize(nearest.Point, nearest.Point);
    this->BestRatio = std::max(this->GetRatio(this->Best), 0.0);
  }
  return this->BestRatio;
}

glm::dvec3 SliceNormal::Turn(const glm::dvec3& preferred) const
{
  if (!(this->BestRatio > 0.0) || this->GetRatio(preferred) >= 1.0)
  {
    return preferred;
  }
  if (this->BestRatio <= 1.0)
  {
    return this->Best;
  }
  // On the chord to the best normal min d_k.x / c_k - |x| is concave: it has one change of sign.
  double bad = 0.0;
  double good = 1.0;
  glm::dvec3 normal = this->Best;
  constexpr int halvings = 50;
  for (int i = 0; i < halvings; ++i)
  {
    const double middle = 0.5 * (bad + good);
    const glm::dvec3 turned =
      Normalize((1.0 - middle) * preferred + middle * this->Best, this->Best);
    if (this->GetRatio(turned) >= 1.0)
    {
      good = middle;
      normal = turned;
    }
    else
    {
      bad = middle;
    }
  }
  return normal;
}

}

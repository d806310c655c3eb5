#include "Plan/SliceNormal.h"

namespace interlume
{

namespace
{

using namespace UnitVector;

// Below this the hull of rays holds 0 as far as rounding lets us see.
constexpr double Smallest = 1e-6;

// The point of a simplex nearest to 0, and its corners that the point is between.
struct Nearest
{
  Vector Point{ { 0.0, 0.0, 0.0 } };
  std::vector<Vector> Corners;
};

// Of the plane, line or point through all corners; false where it is not between them.
bool Project(const std::vector<Vector>& corners, Vector& point)
{
  const Vector& a = corners[0];
  if (corners.size() == 1)
  {
    point = a;
    return true;
  }
  const Vector u = Combine(1.0, corners[1], -1.0, a);
  if (corners.size() == 2)
  {
    const double t = -Dot(a, u) / Dot(u, u);
    point = Combine(1.0, a, t, u);
    return t > 0.0 && t < 1.0;
  }
  const Vector v = Combine(1.0, corners[2], -1.0, a);
  const double determinant = Dot(u, u) * Dot(v, v) - Dot(u, v) * Dot(u, v);
  const double s = (Dot(u, v) * Dot(a, v) - Dot(v, v) * Dot(a, u)) / determinant;
  const double t = (Dot(u, v) * Dot(a, u) - Dot(u, u) * Dot(a, v)) / determinant;
  point = Combine(1.0, Combine(1.0, a, s, u), t, v);
  return s > 0.0 && t > 0.0 && s + t < 1.0;
}

bool HoldsZero(const std::vector<Vector>& corners)
{
  // On the inner side of each face.
  for (std::size_t i = 0; i < 4; ++i)
  {
    const Vector& a = corners[(i + 1) % 4];
    const Vector normal = Cross(
      Combine(1.0, corners[(i + 2) % 4], -1.0, a), Combine(1.0, corners[(i + 3) % 4], -1.0, a));
    const double inside = Dot(normal, Combine(1.0, corners[i], -1.0, a));
    if (!(inside * -Dot(normal, a) > 0.0))
    {
      return false;
    }
  }
  return true;
}

Nearest FindNearest(const std::vector<Vector>& corners)
{
  Nearest nearest;
  if (corners.size() == 4 && HoldsZero(corners))
  {
    return nearest;
  }
  double least = VTK_DOUBLE_MAX;
  const unsigned all = (1u << corners.size()) - 1;
  for (unsigned subset = 1; subset <= all; ++subset)
  {
    std::vector<Vector> face;
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      if (subset >> i & 1u)
      {
        face.push_back(corners[i]);
      }
    }
    Vector point;
    if (face.size() < 4 && Project(face, point) && Dot(point, point) < least)
    {
      least = Dot(point, point);
      nearest.Point = point;
      nearest.Corners = face;
    }
  }
  return nearest;
}

}

void SliceNormal::Add(const Vector& ray, double cosine)
{
  this->Rays.push_back(Scale(1.0 / cosine, ray));
}

void SliceNormal::Add(const std::vector<Vector>& rays, double sign, double cosine)
{
  for (const Vector& ray : rays)
  {
    this->Add(ray, sign * cosine);
  }
}

double SliceNormal::GetRatio(const Vector& normal) const
{
  double ratio = VTK_DOUBLE_MAX;
  for (const Vector& ray : this->Rays)
  {
    ratio = std::min(ratio, Dot(ray, normal));
  }
  return ratio;
}

double SliceNormal::FindBest()
{
  // Gilbert, Johnson, Keerthi: from simplex to simplex of the hull, always nearer to 0.
  Nearest nearest;
  nearest.Corners = { this->Rays.front() };
  nearest.Point = this->Rays.front();
  constexpr int most = 100;
  constexpr double tolerance = 1e-13;
  for (int step = 0; step < most && Length(nearest.Point) > Smallest; ++step)
  {
    const auto next = std::min_element(this->Rays.begin(), this->Rays.end(),
      [&](const Vector& a, const Vector& b)
      { return Dot(a, nearest.Point) < Dot(b, nearest.Point); });
    const double squared = Dot(nearest.Point, nearest.Point);
    if (Dot(*next, nearest.Point) >= squared * (1.0 - tolerance))
    {
      break;
    }
    std::vector<Vector> corners = nearest.Corners;
    corners.push_back(*next);
    const Nearest nearer = FindNearest(corners);
    if (!(Dot(nearer.Point, nearer.Point) < squared))
    {
      break;
    }
    nearest = nearer;
  }
  const double length = Length(nearest.Point);
  this->BestRatio = 0.0;
  if (length > Smallest)
  {
    this->Best = Normalize(nearest.Point, nearest.Point);
    this->BestRatio = std::max(this->GetRatio(this->Best), 0.0);
  }
  return this->BestRatio;
}

SliceNormal::Vector SliceNormal::Turn(const Vector& preferred) const
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
  Vector normal = this->Best;
  constexpr int halvings = 50;
  for (int i = 0; i < halvings; ++i)
  {
    const double middle = 0.5 * (bad + good);
    const Vector turned =
      Normalize(Combine(1.0 - middle, preferred, middle, this->Best), this->Best);
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

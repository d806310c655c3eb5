// SPDX-License-Identifier: BSD-3-Clause
#include "TimeVarying/SimplexProjection.h"

#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

namespace
{
template <typename Real>
using Vector = glm::vec<3, Real>;

template <typename Real>
Real Determinant(const Vector<Real>& a, const Vector<Real>& b, const Vector<Real>& c)
{
  return glm::dot(a, glm::cross(b, c));
}
}

SimplexProjection::SimplexProjection(const std::array<Point, NumberOfPoints>& points, unsigned flat)
{
  if (!this->Compute<double>(points, flat))
  {
    this->Compute<long double>(points, flat);
  }
}

// Computes the dependency. Returns false where too many digits were lost.
template <typename Real>
bool SimplexProjection::Compute(const std::array<Point, NumberOfPoints>& points, unsigned flat)
{
  constexpr Real zero = Real(1) / (1LL << 44);
  constexpr Real enough = Real(1) / (1 << 11);
  *this = SimplexProjection();
  Vector<Real> edges[NumberOfPoints - 1];
  Real longest = 0;
  for (int i = 1; i < NumberOfPoints; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      edges[i - 1][axis] = static_cast<Real>(points[i][axis]) - static_cast<Real>(points[0][axis]);
      longest = std::max(longest, std::abs(edges[i - 1][axis]));
    }
  }
  if (!(longest > 0))
  {
    return true;
  }
  // Edges are scaled to size 1, so that no product overflows or vanishes.
  for (Vector<Real>& edge : edges)
  {
    edge /= longest;
  }
  // Times are counted from one among them.
  Real times[NumberOfPoints];
  for (int i = 0; i < NumberOfPoints; ++i)
  {
    times[i] = static_cast<Real>(points[i][3]) - static_cast<Real>(points[0][3]);
  }
  const auto& [a, b, c, d] = edges;
  Real lambda[NumberOfPoints] = { Determinant<Real>(b - a, c - a, d - a), -Determinant(b, c, d),
    Determinant(a, c, d), -Determinant(a, b, d), Determinant(a, b, c) };
  Real sums[2] = { 0, 0 };
  Real content = 0;
  Real longestTime = 0;
  for (int i = 0; i < NumberOfPoints; ++i)
  {
    lambda[i] = (flat >> i) & 1 ? Real(0) : lambda[i];
    sums[lambda[i] < 0] += std::abs(lambda[i]);
    content += lambda[i] * times[i];
    longestTime = std::max(longestTime, std::abs(times[i]));
  }
  const Real most = std::max(sums[0], sums[1]);
  // For a simplex that is thin in time, less may be left out.
  const Real share = longestTime > 0 ? std::abs(content) / (longestTime * most) : Real(1);
  bool isExact = most > enough;
  sums[0] = sums[1] = 0;
  for (int i = 0; i < NumberOfPoints; ++i)
  {
    isExact = isExact && (std::abs(lambda[i]) > zero * most || lambda[i] == 0);
    lambda[i] = std::abs(lambda[i]) > zero * share * most ? lambda[i] : Real(0);
    this->Signs[i] = static_cast<std::int8_t>(lambda[i] > 0 ? 1 : lambda[i] < 0 ? -1 : 0);
    sums[lambda[i] < 0] += std::abs(lambda[i]);
  }
  if (!(sums[0] > 0) || !(sums[1] > 0))
  {
    this->Signs = {};
    return isExact;
  }
  // The time at the thick point on one face less that on the other.
  Real thickness = 0;
  for (int i = 0; i < NumberOfPoints; ++i)
  {
    const Real part = lambda[i] / sums[lambda[i] < 0];
    thickness += part * times[i];
    this->Weights[i] = static_cast<double>(std::abs(part) / 2);
  }
  this->Thickness = static_cast<double>(std::abs(thickness));
  this->Inverted = thickness < 0;
  return isExact && std::abs(thickness) > enough * longestTime;
}

int SimplexProjection::Count(int sign) const
{
  return static_cast<int>(std::count(this->Signs.begin(), this->Signs.end(), sign));
}

int SimplexProjection::GetClass() const
{
  const int most = std::max(this->Count(1), this->Count(-1));
  switch (10 * most + std::min(this->Count(1), this->Count(-1)))
  {
    case 32:
      return 0;
    case 41:
      return 1;
    case 22:
      return 2;
    case 31:
      return 3;
    case 21:
      return 4;
    default:
      return 5;
  }
}

void SimplexProjection::GetThickPoint(const double* const points[NumberOfPoints], double x[3]) const
{
  // Both faces meet at the thick point: the smaller one gives fewer roundings, and its own point
  // where it is a single one.
  const int side = this->Count(1) < this->Count(-1) ? 1 : -1;
  const bool isPoint = this->Count(side) == 1;
  std::fill_n(x, 3, 0.0);
  for (int i = 0; i < NumberOfPoints; ++i)
  {
    for (int axis = 0; axis < 3 && this->Signs[i] == side; ++axis)
    {
      x[axis] += isPoint ? points[i][axis] : 2.0 * this->Weights[i] * points[i][axis];
    }
  }
}

}

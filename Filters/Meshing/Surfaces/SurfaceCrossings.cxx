// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/SurfaceCrossings.h"

#include "Common/Vectors.h"
#include "Surfaces/ClosedSurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

namespace interlume
{

namespace
{
using Vectors::Difference;

/// Returns the sign of the volume of a, b, c, d, or 0 where rounding might have changed it.
int CertainSign(const double* a, const double* b, const double* c, const double* d)
{
  constexpr double unit = std::numeric_limits<double>::epsilon() / 2;
  constexpr double bound = (7 + 56 * unit) * unit;
  const glm::dvec3 u = Difference(b, a);
  const glm::dvec3 v = Difference(c, a);
  const glm::dvec3 w = Difference(d, a);
  double determinant = 0.0;
  double permanent = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    determinant += u[i] * (v[j] * w[k] - v[k] * w[j]);
    permanent += std::abs(u[i]) * (std::abs(v[j] * w[k]) + std::abs(v[k] * w[j]));
  }
  return std::abs(determinant) <= bound * permanent ? 0 : determinant > 0.0 ? 1 : -1;
}

struct Triangle
{
  const int* Indices;
  const double* Coordinates;

  const double* operator[](int corner) const { return &this->Coordinates[3 * Indices[corner]]; }
};

bool HaveCommonPoint(const Triangle& s, const Triangle& t)
{
  return std::find_first_of(s.Indices, s.Indices + 3, t.Indices, t.Indices + 3) != s.Indices + 3;
}

bool HasEdgeThrough(const Triangle& s, const Triangle& t)
{
  int sides[3];
  for (int i = 0; i < 3; ++i)
  {
    sides[i] = CertainSign(s[i], t[0], t[1], t[2]);
  }
  for (int i = 0; i < 3; ++i)
  {
    const int next = (i + 1) % 3;
    if (sides[i] * sides[next] < 0)
    {
      const int turn = CertainSign(s[i], s[next], t[0], t[1]);
      if (turn != 0 && turn == CertainSign(s[i], s[next], t[1], t[2]) &&
        turn == CertainSign(s[i], s[next], t[2], t[0]))
      {
        return true;
      }
    }
  }
  return false;
}

/// The box of a triangle.
struct Extents
{
  std::size_t Owner;
  glm::dvec3 Least;
  glm::dvec3 Most;

  Extents(std::size_t owner, const Triangle& t)
    : Owner(owner)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      std::tie(this->Least[axis], this->Most[axis]) =
        std::minmax({ t[0][axis], t[1][axis], t[2][axis] });
    }
  }

  bool Meets(const Extents& other) const
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (this->Most[axis] < other.Least[axis] || other.Most[axis] < this->Least[axis])
      {
        return false;
      }
    }
    return true;
  }
};

/// Returns the axis along which triangles are shortest beside the whole surface.
int ChooseAxis(const std::vector<Extents>& boxes)
{
  int best = 0;
  double shortest = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
  {
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    double sum = 0.0;
    for (const Extents& box : boxes)
    {
      least = std::min(least, box.Least[axis]);
      most = std::max(most, box.Most[axis]);
      sum += box.Most[axis] - box.Least[axis];
    }
    if (sum < shortest * (most - least))
    {
      shortest = sum / (most - least);
      best = axis;
    }
  }
  return best;
}
}

std::vector<vtkIdType> SurfaceCrossings::FindCells(const ClosedSurface& surface)
{
  std::vector<Triangle> triangles;
  std::vector<Extents> boxes;
  for (std::size_t t = 0; t < surface.Triangles.size(); t += 3)
  {
    triangles.push_back({ &surface.Triangles[t], surface.Points.Coordinates.data() });
    boxes.emplace_back(t / 3, triangles.back());
  }
  const int axis = ChooseAxis(boxes);
  std::sort(boxes.begin(), boxes.end(),
    [axis](const Extents& a, const Extents& b) { return a.Least[axis] < b.Least[axis]; });

  std::vector<vtkIdType> cells;
  for (auto one = boxes.begin(); one != boxes.end(); ++one)
  {
    for (auto other = one + 1; other != boxes.end() && other->Least[axis] <= one->Most[axis];
         ++other)
    {
      const Triangle& s = triangles[one->Owner];
      const Triangle& t = triangles[other->Owner];
      if (one->Meets(*other) && !HaveCommonPoint(s, t) &&
        (HasEdgeThrough(s, t) || HasEdgeThrough(t, s)))
      {
        cells.push_back(surface.CellIds[one->Owner]);
        cells.push_back(surface.CellIds[other->Owner]);
      }
    }
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/SurfaceCrossings.h"

#include "Common/Vectors.h"
#include "Surfaces/ClosedSurface.h"
#include "Surfaces/TrianglePairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace interlume
{

namespace
{
using Vectors::Difference;

/// Returns the orientation of the tetrahedron a, b, c, d: the sign of its volume, or 0 if rounding
/// error may have changed the sign.
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
  const ClosedSurface& Surface;
  const std::array<int, 3>& Points;

  const double* operator[](int corner) const
  {
    return this->Surface.GetPoint(this->Points[corner]);
  }
};

bool HaveCommonPoint(const Triangle& s, const Triangle& t)
{
  return std::find_first_of(s.Points.begin(), s.Points.end(), t.Points.begin(), t.Points.end()) !=
    s.Points.end();
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
      const int sign = CertainSign(s[i], s[next], t[0], t[1]);
      if (sign != 0 && sign == CertainSign(s[i], s[next], t[1], t[2]) &&
        sign == CertainSign(s[i], s[next], t[2], t[0]))
      {
        return true;
      }
    }
  }
  return false;
}
}

std::vector<vtkIdType> SurfaceCrossings::FindCells(const ClosedSurface& surface)
{
  std::vector<vtkIdType> cells;
  TrianglePairs::ForEach(surface, 0.0,
    [&](int one, int other)
    {
      const Triangle s{ surface, surface.Triangles[one].Points };
      const Triangle t{ surface, surface.Triangles[other].Points };
      if (!HaveCommonPoint(s, t) && (HasEdgeThrough(s, t) || HasEdgeThrough(t, s)))
      {
        cells.push_back(surface.Triangles[one].Cell);
        cells.push_back(surface.Triangles[other].Cell);
      }
    });
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

}

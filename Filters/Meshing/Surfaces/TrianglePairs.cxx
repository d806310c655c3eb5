// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/TrianglePairs.h"

#include "Surfaces/ClosedSurface.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include <glm/vec3.hpp>

namespace interlume
{

namespace
{
/// Bounding box of a triangle.
struct Extents
{
  int Owner;
  glm::dvec3 Lower;
  glm::dvec3 Upper;

  Extents(int owner, const double* a, const double* b, const double* c, double margin)
    : Owner(owner)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      std::tie(this->Lower[axis], this->Upper[axis]) = std::minmax({ a[axis], b[axis], c[axis] });
      this->Upper[axis] += margin;
    }
  }

  bool Intersects(const Extents& other) const
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (this->Upper[axis] < other.Lower[axis] || other.Upper[axis] < this->Lower[axis])
      {
        return false;
      }
    }
    return true;
  }
};

/// Returns the axis along which the boxes are, on average, shortest relative to the extent of all
/// boxes.
int ChooseAxis(const std::vector<Extents>& boxes)
{
  int best = 0;
  double shortest = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
  {
    double lower = std::numeric_limits<double>::infinity();
    double upper = -lower;
    double sum = 0.0;
    for (const Extents& box : boxes)
    {
      lower = std::min(lower, box.Lower[axis]);
      upper = std::max(upper, box.Upper[axis]);
      sum += box.Upper[axis] - box.Lower[axis];
    }
    if (sum < shortest * (upper - lower))
    {
      shortest = sum / (upper - lower);
      best = axis;
    }
  }
  return best;
}
}

void TrianglePairs::ForEach(
  const ClosedSurface& surface, double distance, const std::function<void(int, int)>& function)
{
  std::vector<Extents> boxes;
  for (const ClosedSurface::Triangle& triangle : surface.Triangles)
  {
    const auto& p = triangle.Points;
    boxes.emplace_back(static_cast<int>(boxes.size()), surface.GetPoint(p[0]),
      surface.GetPoint(p[1]), surface.GetPoint(p[2]), distance);
  }
  const int axis = ChooseAxis(boxes);
  std::sort(boxes.begin(), boxes.end(),
    [axis](const Extents& a, const Extents& b)
    { return std::tie(a.Lower[axis], a.Owner) < std::tie(b.Lower[axis], b.Owner); });
  for (auto one = boxes.begin(); one != boxes.end(); ++one)
  {
    for (auto other = one + 1; other != boxes.end() && other->Lower[axis] <= one->Upper[axis];
         ++other)
    {
      if (one->Intersects(*other))
      {
        function(one->Owner, other->Owner);
      }
    }
  }
}

}

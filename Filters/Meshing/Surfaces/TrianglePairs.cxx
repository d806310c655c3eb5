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
/// The box of a triangle.
struct Extents
{
  int Owner;
  glm::dvec3 Least;
  glm::dvec3 Most;

  Extents(int owner, const double* a, const double* b, const double* c, double margin)
    : Owner(owner)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      std::tie(this->Least[axis], this->Most[axis]) = std::minmax({ a[axis], b[axis], c[axis] });
      this->Most[axis] += margin;
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
    { return std::tie(a.Least[axis], a.Owner) < std::tie(b.Least[axis], b.Owner); });
  for (auto one = boxes.begin(); one != boxes.end(); ++one)
  {
    for (auto other = one + 1; other != boxes.end() && other->Least[axis] <= one->Most[axis];
         ++other)
    {
      if (one->Meets(*other))
      {
        function(one->Owner, other->Owner);
      }
    }
  }
}

}

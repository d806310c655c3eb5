// SPDX-License-Identifier: BSD-3-Clause
#include "Plan/VolumeOrder.h"

#include "Space/BoxCorners.h"
#include "Space/UnitSpace.h"
#include "Space/UnitVector.h"

#include <algorithm>
#include <limits>

namespace interlume
{

namespace
{

using namespace UnitVector;

// Boxes that overlap by less than this are treated as separate.
constexpr double OverlapTolerance = 1e-6;

// The order is undefined for a point closer than this to the separating plane, and for a direction
// whose cosine with the plane's normal is smaller.
constexpr double ParallelTolerance = 1e-9;

// A plane n.x = Height that separates two boxes. The normal n points toward the second box.
struct SeparatingPlane
{
  bool IsFound = false;
  glm::dvec3 Normal{ 0.0, 0.0, 0.0 };
  double Height = 0.0;
};

SeparatingPlane FindSeparatingPlane(
  const SlicePlan::SlicedVolume& first, const SlicePlan::SlicedVolume& second)
{
  const BoxCorners a(*first.Space, first.Box);
  const BoxCorners b(*second.Space, second.Box);
  SeparatingPlane best;
  double widest = -OverlapTolerance;
  for (const SlicePlan::SlicedVolume* volume : { &first, &second })
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const glm::dvec3 face =
        Normalize(GetRow(volume->Space->TextureFromUnit, axis), glm::dvec3(0.0));
      for (const double sign : { 1.0, -1.0 })
      {
        const double end = a.GetRange(sign * face)[1];
        const double begin = b.GetRange(sign * face)[0];
        if (begin - end > widest)
        {
          widest = begin - end;
          best = { true, sign * face, 0.5 * (begin + end) };
        }
      }
    }
  }
  return best;
}

// Returns 1 if rays from a point or along a direction pass through the first box first, -1 if they
// pass through the second box first, and 0 if the order is undefined.
int GetSide(
  const SeparatingPlane& plane, bool hasPoint, const glm::dvec3& point, const glm::dvec3& ray)
{
  const double along =
    hasPoint ? plane.Height - glm::dot(plane.Normal, point) : glm::dot(plane.Normal, ray);
  return along > ParallelTolerance ? 1 : along < -ParallelTolerance ? -1 : 0;
}

}

void VolumeOrder::Find(const SlicePlan::Sweep& sweep, const SlicePlan::Camera& eye,
  const std::vector<LightSource>& lights, const std::vector<SlicePlan::SlicedVolume>& volumes)
{
  const auto compare = [&](std::size_t i, std::size_t j)
  {
    const SeparatingPlane plane = FindSeparatingPlane(volumes[i], volumes[j]);
    int side = 0;
    for (std::size_t k = 0; k < sweep.Lights.size() && plane.IsFound && side == 0; ++k)
    {
      const LightSource& light = lights[static_cast<std::size_t>(sweep.Lights[k].Light)];
      side = GetSide(plane, light.IsPositional, light.Position, light.Direction);
    }
    if (plane.IsFound && side == 0)
    {
      side = (sweep.IsFrontToBack ? 1 : -1) *
        GetSide(plane, !eye.IsParallel, eye.Position, eye.Direction);
    }
    return side;
  };
  const std::size_t count = volumes.size();
  std::vector<int> sides(count * count, 0);
  for (std::size_t i = 0; i < count; ++i)
  {
    for (std::size_t j = i + 1; j < count; ++j)
    {
      sides[i * count + j] = compare(i, j);
      sides[j * count + i] = -sides[i * count + j];
    }
  }
  for (std::vector<std::size_t>& order : this->Orders)
  {
    std::vector<std::size_t> remaining;
    for (std::size_t i = 0; i < count; ++i)
    {
      remaining.push_back(&order == this->Orders.data() ? i : count - 1 - i);
    }
    order.clear();
    while (!remaining.empty())
    {
      // If the remaining volumes precede each other in a cycle, take any of them.
      auto next = std::find_if(remaining.begin(), remaining.end(),
        [&](std::size_t i)
        {
          return std::none_of(remaining.begin(), remaining.end(),
            [&](std::size_t j) { return sides[j * count + i] > 0; });
        });
      next = next == remaining.end() ? remaining.begin() : next;
      order.push_back(*next);
      remaining.erase(next);
    }
  }
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Plan/SlabOrder.h"

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

// Boxes that reach into each other by no more than rounding stand apart.
constexpr double Rounding = 1e-6;

// Light along a plane between boxes has no order.
constexpr double Nothing = 1e-9;

// A plane n.x = Height that stands between two boxes, n towards the second one.
struct Border
{
  bool IsFound = false;
  glm::dvec3 Normal{ 0.0, 0.0, 0.0 };
  double Height = 0.0;
};

Border FindBorder(const SlicePlan::Matter& first, const SlicePlan::Matter& second)
{
  const BoxCorners a(*first.Space, first.Box);
  const BoxCorners b(*second.Space, second.Box);
  Border best;
  double widest = -Rounding;
  for (const SlicePlan::Matter* volume : { &first, &second })
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

// Returns 1 where rays from or to a place, or along a direction, come through the first box first,
// -1 where they come through the second one first, and 0 where that cannot be said.
int GetSide(const Border& border, bool hasPlace, const glm::dvec3& place, const glm::dvec3& ray)
{
  const double along =
    hasPlace ? border.Height - glm::dot(border.Normal, place) : glm::dot(border.Normal, ray);
  return along > Nothing ? 1 : along < -Nothing ? -1 : 0;
}

}

void SlabOrder::Find(const SlicePlan::Sweep& sweep, const SlicePlan::Eye& eye,
  const std::vector<LightSource>& lights, const std::vector<SlicePlan::Matter>& matter)
{
  const auto compare = [&](std::size_t i, std::size_t j)
  {
    const Border border = FindBorder(matter[i], matter[j]);
    int side = 0;
    for (std::size_t k = 0; k < sweep.Lights.size() && border.IsFound && side == 0; ++k)
    {
      const LightSource& light = lights[static_cast<std::size_t>(sweep.Lights[k].Light)];
      side = GetSide(border, light.IsPositional, light.Position, light.Direction);
    }
    if (border.IsFound && side == 0)
    {
      side = (sweep.IsFrontToBack ? 1 : -1) *
        GetSide(border, !eye.IsParallel, eye.Position, eye.Direction);
    }
    return side;
  };
  const std::size_t count = matter.size();
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
    std::vector<std::size_t> left;
    for (std::size_t i = 0; i < count; ++i)
    {
      left.push_back(&order == this->Orders.data() ? i : count - 1 - i);
    }
    order.clear();
    while (!left.empty())
    {
      // Where volumes stand around each other in a ring, none is first.
      auto next = std::find_if(left.begin(), left.end(),
        [&](std::size_t i)
        {
          return std::none_of(
            left.begin(), left.end(), [&](std::size_t j) { return sides[j * count + i] > 0; });
        });
      next = next == left.end() ? left.begin() : next;
      order.push_back(*next);
      left.erase(next);
    }
  }
}

}

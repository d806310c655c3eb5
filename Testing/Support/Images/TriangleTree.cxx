// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Images/TriangleTree.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace reference
{

namespace
{

constexpr int LeafSize = 4;

/// A ray in a sheared coordinate system whose z-axis is the ray.
class ShearedRay
{
public:
  ShearedRay(const glm::dvec3& origin, const glm::dvec3& direction)
    : Origin(origin)
    , Direction(direction)
  {
    const glm::dvec3 size = glm::abs(direction);
    this->Z = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    this->X = (this->Z + 1) % 3;
    this->Y = (this->Z + 2) % 3;
  }

  bool Intersect(const TriangleTree::Triangle& triangle, TriangleTree::Hit& meeting) const
  {
    const glm::dvec3 a = this->Shear(triangle[0]);
    const glm::dvec3 b = this->Shear(triangle[1]);
    const glm::dvec3 c = this->Shear(triangle[2]);
    const double u = c.x * b.y - c.y * b.x;
    const double v = a.x * c.y - a.y * c.x;
    const double w = b.x * a.y - b.y * a.x;
    const double sum = u + v + w;
    if ((std::min({ u, v, w }) < 0.0 && std::max({ u, v, w }) > 0.0) || sum == 0.0)
    {
      return false;
    }
    meeting.Distance = (u * a.z + v * b.z + w * c.z) / sum;
    meeting.Weights = { { v / sum, w / sum } };
    return true;
  }

  /// Returns whether the ray meets the box at any distance in [begin, end].
  bool IntersectsBox(
    const glm::dvec3& lower, const glm::dvec3& upper, double begin, double end) const
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (this->Direction[axis] == 0.0)
      {
        if (this->Origin[axis] < lower[axis] || this->Origin[axis] > upper[axis])
        {
          return false;
        }
        continue;
      }
      const double s = (lower[axis] - this->Origin[axis]) / this->Direction[axis];
      const double t = (upper[axis] - this->Origin[axis]) / this->Direction[axis];
      begin = std::max(begin, std::min(s, t) - Slack * std::abs(s));
      end = std::min(end, std::max(s, t) + Slack * std::abs(t));
    }
    return begin <= end;
  }

private:
  /// Relative tolerance for rounding errors of distances to box faces.
  static constexpr double Slack = 1e-13;

  glm::dvec3 Shear(const glm::dvec3& point) const
  {
    const glm::dvec3 p = point - this->Origin;
    const double z = p[this->Z] / this->Direction[this->Z];
    return { p[this->X] - z * this->Direction[this->X], p[this->Y] - z * this->Direction[this->Y],
      z };
  }

  glm::dvec3 Origin;
  glm::dvec3 Direction;
  int X;
  int Y;
  int Z;
};

}

void TriangleTree::Build(std::vector<Triangle> triangles)
{
  this->Triangles = std::move(triangles);
  this->Items.resize(this->Triangles.size());
  std::iota(this->Items.begin(), this->Items.end(), 0);
  this->Nodes.clear();
  if (!this->Items.empty())
  {
    this->Nodes.emplace_back();
    this->BuildNode(0, 0, static_cast<int>(this->Items.size()));
  }
}

void TriangleTree::BuildNode(int node, int first, int last)
{
  const double infinite = std::numeric_limits<double>::infinity();
  glm::dvec3 lower(infinite);
  glm::dvec3 upper(-infinite);
  for (int i = first; i < last; ++i)
  {
    for (const glm::dvec3& corner : this->Triangles[this->Items[i]])
    {
      lower = glm::min(lower, corner);
      upper = glm::max(upper, corner);
    }
  }
  if (last - first <= LeafSize)
  {
    this->Nodes[node] = { lower, upper, first, last - first };
    return;
  }
  const glm::dvec3 size = upper - lower;
  const int axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
  const auto key = [&](int item)
  {
    const Triangle& t = this->Triangles[item];
    return std::make_pair(t[0][axis] + t[1][axis] + t[2][axis], item);
  };
  const int midpoint = first + (last - first) / 2;
  std::nth_element(this->Items.begin() + first, this->Items.begin() + midpoint,
    this->Items.begin() + last, [&](int a, int b) { return key(a) < key(b); });
  const int child = static_cast<int>(this->Nodes.size());
  this->Nodes[node] = { lower, upper, child, 0 };
  this->Nodes.resize(this->Nodes.size() + 2);
  this->BuildNode(child, first, midpoint);
  this->BuildNode(child + 1, midpoint, last);
}

void TriangleTree::Visit(const glm::dvec3& origin, const glm::dvec3& direction, double begin,
  double end, const std::function<bool(const Hit&)>& visit) const
{
  const ShearedRay sheared(origin, direction);
  // The stack cannot overflow: a tree with INT_MAX triangles has about 30 levels.
  std::array<int, 64> stack;
  int size = 0;
  if (!this->Nodes.empty())
  {
    stack[size++] = 0;
  }
  while (size > 0)
  {
    const Node& node = this->Nodes[stack[--size]];
    if (!sheared.IntersectsBox(node.Lower, node.Upper, begin, end))
    {
      continue;
    }
    if (node.NumberOfItems == 0)
    {
      stack[size++] = node.First;
      stack[size++] = node.First + 1;
    }
    for (int i = 0; i < node.NumberOfItems; ++i)
    {
      Hit meeting{};
      meeting.Triangle = this->Items[node.First + i];
      if (sheared.Intersect(this->Triangles[meeting.Triangle], meeting) &&
        meeting.Distance > begin && meeting.Distance < end && !visit(meeting))
      {
        return;
      }
    }
  }
}

}

// SPDX-License-Identifier: BSD-3-Clause
#ifndef TriangleTree_h
#define TriangleTree_h

#include <glm/vec3.hpp>

#include <array>
#include <functional>
#include <vector>

namespace reference
{

/**
 * @class   TriangleTree
 * @brief   finds the triangles that a ray meets, in double
 *
 * A binary tree of bounding boxes, cut at the median of the longest axis. A ray meets a triangle by
 * the signs of its volumes with the three edges (Woop, Benthin, Wald 2013), so that none passes
 * between two triangles of one edge. Queries change nothing; threads may make them at once.
 */
class TriangleTree
{
public:
  using Triangle = std::array<glm::dvec3, 3>;

  struct Meeting
  {
    double Distance;
    int Triangle;
    /// Of the second and third corner.
    std::array<double, 2> Weights;
  };

  /// Builds the tree in place of the one before.
  void Build(std::vector<Triangle> triangles);

  const Triangle& Get(int triangle) const { return this->Triangles[triangle]; }

  /// Calls \a visit for all that the ray meets at distances in (begin, end), in no order, until it
  /// returns false.
  void Visit(const glm::dvec3& origin, const glm::dvec3& direction, double begin, double end,
    const std::function<bool(const Meeting&)>& visit) const;

private:
  struct Node
  {
    glm::dvec3 Lower;
    glm::dvec3 Upper;
    /// The first of its items, or of its two children where it has no items.
    int First;
    int NumberOfItems;
  };
  void BuildNode(int node, int first, int last);

  std::vector<Triangle> Triangles;
  std::vector<int> Items;
  std::vector<Node> Nodes;
};

}

#endif

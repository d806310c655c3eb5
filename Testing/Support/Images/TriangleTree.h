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
 * @brief   finds the triangles that a ray hits, in double precision
 *
 * A binary tree of bounding boxes, split at the median along the longest axis. Hits are determined
 * by the signs of the volumes that the ray spans with the three edges (Woop, Benthin, Wald 2013).
 * Therefore, no ray passes between two triangles with a common edge. Queries are thread-safe.
 */
class TriangleTree
{
public:
  using Triangle = std::array<glm::dvec3, 3>;

  struct Hit
  {
    double Distance;
    int Triangle;
    /// Barycentric weights of the second and third corner.
    std::array<double, 2> Weights;
  };

  /// Builds a tree, replacing the previous one.
  void Build(std::vector<Triangle> triangles);

  const Triangle& Get(int triangle) const { return this->Triangles[triangle]; }

  /// Calls \a visit for all hits at distances in (begin, end), in any order, until it returns
  /// false.
  void Visit(const glm::dvec3& origin, const glm::dvec3& direction, double begin, double end,
    const std::function<bool(const Hit&)>& visit) const;

private:
  struct Node
  {
    glm::dvec3 Lower;
    glm::dvec3 Upper;
    /// Index of the first item, or of the first of two children if there are no items.
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

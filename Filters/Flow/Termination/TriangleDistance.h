// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TriangleDistance_h
#define interlume_TriangleDistance_h

#include "Termination/BoxTree.h"
#include "Termination/ClosestTrianglePoint.h"
#include "Termination/TerminationTriangles.h"
#include "Termination/TriangleEdges.h"

#include <vector>

namespace interlume
{

/**
 * @class   TriangleDistance
 * @brief   the nearest point of oriented triangles, and the side it is seen from
 *
 * The side is that of the normal of the face, edge or vertex that the nearest point is on, edges
 * and vertices with the normals of their faces weighted by angle: J. A. Baerentzen and H. Aanaes,
 * "Signed distance computation using the angle weighted pseudonormal", IEEE TVCG 11(3), 2005.
 */
class TriangleDistance
{
public:
  /// Takes triangles that stay where they are.
  void Build(const TerminationTriangles* mesh, const TriangleEdges& edges);

  /// Returns the triangle that is nearest to \a x, -1 without any, and then leaves \a foot as it
  /// is.
  int FindNearest(const glm::dvec3& x, ClosestTrianglePoint& foot) const;

  /// Returns the normal at a foot in a triangle, of length 1.
  const glm::dvec3& GetNormal(int triangle, const ClosestTrianglePoint& foot) const;
  bool IsOnBorder(int triangle, const ClosestTrianglePoint& foot) const;

  /// Returns the signed distance of \a x from its foot.
  double GetSignedDistance(
    int triangle, const ClosestTrianglePoint& foot, const glm::dvec3& x) const;

private:
  const TerminationTriangles* Mesh = nullptr;
  BoxTree Tree;
  /// The three edges of each triangle.
  std::vector<int> EdgeIds;
  std::vector<glm::dvec3> FaceNormals;
  std::vector<glm::dvec3> EdgeNormals;
  std::vector<glm::dvec3> VertexNormals;
  std::vector<bool> IsBorderEdge;
  std::vector<bool> IsBorderVertex;
};

}

#endif

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
 * @brief   signed distance from oriented triangles
 *
 * The sign is determined by the normal of the face, edge or vertex that contains the nearest point.
 * Edge and vertex normals are angle-weighted sums of adjacent face normals: J. A. Baerentzen and H.
 * Aanaes, "Signed distance computation using the angle weighted pseudonormal", IEEE TVCG 11(3),
 * 2005.
 */
class TriangleDistance
{
public:
  /// Builds the search structure. The mesh must outlive this object.
  void Build(const TerminationTriangles* mesh, const TriangleEdges& edges);

  /// Returns the triangle nearest to \a x and computes \a foot. Returns -1 and leaves \a foot
  /// unchanged if there are no triangles.
  int FindNearest(const glm::dvec3& x, ClosestTrianglePoint& foot) const;

  /// Returns the unit normal at the point \a foot of a triangle.
  const glm::dvec3& GetNormal(int triangle, const ClosestTrianglePoint& foot) const;
  bool IsOnBorder(int triangle, const ClosestTrianglePoint& foot) const;

  /// Returns the signed distance of \a x from the triangle.
  double GetSignedDistance(
    int triangle, const ClosestTrianglePoint& foot, const glm::dvec3& x) const;

private:
  const TerminationTriangles* Mesh = nullptr;
  BoxTree Tree;
  /// Three edge ids per triangle.
  std::vector<int> EdgeIds;
  std::vector<glm::dvec3> FaceNormals;
  std::vector<glm::dvec3> EdgeNormals;
  std::vector<glm::dvec3> VertexNormals;
  std::vector<bool> IsBorderEdge;
  std::vector<bool> IsBorderVertex;
};

}

#endif

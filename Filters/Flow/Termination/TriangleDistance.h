#ifndef interlume_TriangleDistance_h
#define interlume_TriangleDistance_h

#include "Termination/BoxTree.h"
#include "Termination/ClosestTrianglePoint.h"
#include "Termination/TerminationTriangles.h"
#include "Termination/TriangleEdges.h"

#include <array>
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

  /// The triangle that is nearest to \a x, -1 without any; the foot is left then.
  int FindNearest(const double x[3], ClosestTrianglePoint& foot) const;

  /// Of a foot in a triangle, of length 1.
  const double* GetNormal(int triangle, const ClosestTrianglePoint& foot) const;
  bool IsOnBorder(int triangle, const ClosestTrianglePoint& foot) const;

  /// Of a foot of \a x.
  double GetSignedDistance(int triangle, const ClosestTrianglePoint& foot, const double x[3]) const;

private:
  using Vector = std::array<double, 3>;

  const TerminationTriangles* Mesh = nullptr;
  BoxTree Tree;
  /// Three of each triangle.
  std::vector<int> EdgeIds;
  std::vector<Vector> FaceNormals;
  std::vector<Vector> EdgeNormals;
  std::vector<Vector> VertexNormals;
  std::vector<bool> IsBorderEdge;
  std::vector<bool> IsBorderVertex;
};

}

#endif

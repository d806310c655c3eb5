#ifndef vtkTriangleDistance_h
#define vtkTriangleDistance_h

#include "vtkBoxTree.h"
#include "vtkTerminationTriangles.h"
#include "vtkTriangleEdges.h"
#include "vtkTriangleFoot.h"

#include <array>
#include <vector>

/**
 * @class   vtkTriangleDistance
 * @brief   the nearest point of oriented triangles, and the side it is seen from
 *
 * The side is that of the normal of the face, edge or vertex that the nearest point is on, edges
 * and vertices with the normals of their faces weighted by angle: J. A. Baerentzen and H. Aanaes,
 * "Signed distance computation using the angle weighted pseudonormal", IEEE TVCG 11(3), 2005.
 */
class vtkTriangleDistance
{
public:
  /// Takes triangles that stay where they are.
  void Build(const vtkTerminationTriangles* mesh, const vtkTriangleEdges& edges);

  /// The triangle that is nearest to \a x, -1 without any; the foot is left then.
  int FindNearest(const double x[3], vtkTriangleFoot& foot) const;

  /// Of a foot in a triangle, of length 1.
  const double* GetNormal(int triangle, const vtkTriangleFoot& foot) const;
  bool IsOnBorder(int triangle, const vtkTriangleFoot& foot) const;

  /// Of a foot of \a x.
  double GetSignedDistance(int triangle, const vtkTriangleFoot& foot, const double x[3]) const;

private:
  using Vector = std::array<double, 3>;

  const vtkTerminationTriangles* Mesh = nullptr;
  vtkBoxTree Tree;
  /// Three of each triangle.
  std::vector<int> EdgeIds;
  std::vector<Vector> FaceNormals;
  std::vector<Vector> EdgeNormals;
  std::vector<Vector> VertexNormals;
  std::vector<bool> IsBorderEdge;
  std::vector<bool> IsBorderVertex;
};

#endif

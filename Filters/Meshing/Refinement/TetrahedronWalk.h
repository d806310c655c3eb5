// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TetrahedronWalk_h
#define interlume_TetrahedronWalk_h

#include <array>

namespace interlume
{

struct TetGenSolution;

/**
 * @class   TetrahedronWalk
 * @brief   finds the tetrahedron of a Delaunay mesh that contains a point
 *
 * Starts at the last result and moves from neighbor to neighbor, each time through the face
 * opposite the corner with the most negative barycentric coordinate.
 */
class TetrahedronWalk
{
public:
  /// Sets the mesh, which must outlive this object. Its Neighbors must be set.
  explicit TetrahedronWalk(const TetGenSolution& mesh);

  /// Finds the tetrahedron that contains \a point and its barycentric coordinates \a weights. For a
  /// point outside the mesh, returns the tetrahedron with the largest minimum weight.
  int Find(const double* point, std::array<double, 4>& weights);

private:
  std::array<double, 4> GetWeights(int tetrahedron, const double* point) const;
  int Search(const double* point) const;

  const TetGenSolution& Mesh;
  int Last = 0;
};

}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TetrahedronWalk_h
#define interlume_TetrahedronWalk_h

#include <array>

namespace interlume
{

struct TetGenSolution;

/**
 * @class   TetrahedronWalk
 * @brief   finds the tetrahedron of a Delaunay mesh that a point lies in
 *
 * It walks from the tetrahedron found last through the face that the point lies farthest beyond.
 */
class TetrahedronWalk
{
public:
  /// Takes a mesh, which has neighbours and must outlive this object.
  explicit TetrahedronWalk(const TetGenSolution& mesh);

  /// Finds the tetrahedron of \a point, and its barycentric coordinates there. A point outside gets
  /// the tetrahedron nearest to having it.
  int Find(const double* point, std::array<double, 4>& weights);

private:
  std::array<double, 4> GetWeights(int tetrahedron, const double* point) const;
  int Search(const double* point) const;

  const TetGenSolution& Mesh;
  int Last = 0;
};

}

#endif

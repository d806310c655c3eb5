#ifndef vtkTetrahedronWalk_h
#define vtkTetrahedronWalk_h

#include <array>

struct vtkTetGenSolution;

/**
 * @class   vtkTetrahedronWalk
 * @brief   finds the tetrahedron of a Delaunay mesh that a point lies in
 *
 * Walks from the tetrahedron found last through the face that the point lies farthest beyond.
 */
class vtkTetrahedronWalk
{
public:
  /// \a mesh has neighbours and must outlive this object.
  explicit vtkTetrahedronWalk(const vtkTetGenSolution& mesh);

  /// The tetrahedron of \a point, and its barycentric coordinates there. A point outside gets the
  /// tetrahedron nearest to having it.
  int Find(const double* point, std::array<double, 4>& weights);

private:
  std::array<double, 4> GetWeights(int tetrahedron, const double* point) const;
  int Search(const double* point) const;

  const vtkTetGenSolution& Mesh;
  int Last = 0;
};

#endif

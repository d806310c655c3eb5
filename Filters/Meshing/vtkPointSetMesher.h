#ifndef vtkPointSetMesher_h
#define vtkPointSetMesher_h

struct vtkMeshingJob;

/**
 * @class   vtkPointSetMesher
 * @brief   the Delaunay tetrahedra of a set of points, refined where a bound is set
 *
 * A point that refinement adds has the values of the linear interpolation in the Delaunay
 * tetrahedron of the input's points that it lies in.
 */
class vtkPointSetMesher
{
public:
  static void Execute(vtkMeshingJob& job);
};

#endif

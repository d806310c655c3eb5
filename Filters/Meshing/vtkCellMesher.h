#ifndef vtkCellMesher_h
#define vtkCellMesher_h

struct vtkMeshingJob;

/**
 * @class   vtkCellMesher
 * @brief   cuts the three-dimensional cells of a dataset into tetrahedra that fit together
 *
 * A face is cut by vtkFaceTriangulation, in the order of the point data's global ids where there
 * are some and of the point ids otherwise, so that cells on both sides have the same triangles.
 */
class vtkCellMesher
{
public:
  static void Execute(vtkMeshingJob& job);
};

#endif

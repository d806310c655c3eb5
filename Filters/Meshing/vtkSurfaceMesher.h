#ifndef vtkSurfaceMesher_h
#define vtkSurfaceMesher_h

struct vtkMeshingJob;

/**
 * @class   vtkSurfaceMesher
 * @brief   fills closed surfaces with tetrahedra
 */
class vtkSurfaceMesher
{
public:
  static void Execute(vtkMeshingJob& job);
};

#endif

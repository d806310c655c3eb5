#ifndef vtkTextureSearch_h
#define vtkTextureSearch_h

#include "vtkBoxTree.h"
#include "vtkTerminationTriangles.h"

/**
 * @class   vtkTextureSearch
 * @brief   the point of a mesh that has given texture coordinates
 *
 * Triangles without area in the texture are left out. Where triangles overlap in the texture one of
 * them is found, always the same.
 */
class vtkTextureSearch
{
public:
  /// Takes triangles that stay where they are.
  void Build(const vtkTerminationTriangles* mesh, const bool isPeriodic[2]);

  /// False where no triangle is within vtkTerminationSurface::BorderTolerance.
  bool FindPoint(const double uv[2], double x[3]) const;

private:
  const vtkTerminationTriangles* Mesh = nullptr;
  vtkBoxTree Tree;
  bool IsPeriodic[2] = { false, false };
};

#endif

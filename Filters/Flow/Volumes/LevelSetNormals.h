// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LevelSetNormals_h
#define interlume_LevelSetNormals_h

#include "Volumes/SurfaceTriangles.h"

#include "vtkSmartPointer.h"

class vtkDataArray;
class vtkFloatArray;
class vtkUnstructuredGrid;

namespace interlume
{

/**
 * @class   LevelSetNormals
 * @brief   point normals of level sets, from the gradients in the tetrahedra around
 */
class LevelSetNormals
{
public:
  /**
   * Computes a normal for each point of \a mesh, a tetrahedral mesh, that is in one of \a
   * triangles: the direction against the gradient of \a function, averaged by volume over the
   * tetrahedra of the point; where that is 0, the mean normal of the triangles. Normals have three
   * floats, 0 at other points.
   */
  static vtkSmartPointer<vtkFloatArray> Compute(vtkUnstructuredGrid* mesh, vtkDataArray* function,
    const std::vector<SurfaceTriangles::Triangle>& triangles);
};

}

#endif

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
 * @brief   point normals of level sets, from gradients in the surrounding tetrahedra
 */
class LevelSetNormals
{
public:
  /**
   * Computes the normals of the points of \a triangles in the tetrahedral \a mesh. A normal is the
   * negative gradient of \a function, averaged over the tetrahedra at the point, weighted by
   * volume. If the average is 0, the mean normal of the triangles is used. Normals have three float
   * components, which are 0 at points without a triangle.
   */
  static vtkSmartPointer<vtkFloatArray> Compute(vtkUnstructuredGrid* mesh, vtkDataArray* function,
    const std::vector<SurfaceTriangles::Triangle>& triangles);
};

}

#endif

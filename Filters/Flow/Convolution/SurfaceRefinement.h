// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SurfaceRefinement_h
#define interlume_SurfaceRefinement_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkDataSet;
class vtkPolyData;

namespace interlume
{

/**
 * @class   SurfaceRefinement
 * @brief   divides the triangles of a surface until their edges are short
 *
 * Each pass adds the midpoints of all edges that are too long, and cuts each triangle with one, two
 * or three midpoints into two, three or four triangles. Neighbors share midpoints, so the refined
 * surface has no cracks. Point arrays are interpolated, cell arrays copied.
 */
class SurfaceRefinement
{
public:
  /// Triangulates the polygons and strips of \a surface. Vertices and lines are removed.
  explicit SurfaceRefinement(vtkDataSet* surface);

  /**
   * Returns the shortest maximum edge length that is at least \a length and adds at most about
   * \a maximumTriangles triangles. The number is estimated from the areas and the lengths of the
   * triangles.
   */
  double FindLength(double length, vtkIdType maximumTriangles) const;

  /// Returns the surface with edges of at most \a length, which must be positive.
  vtkSmartPointer<vtkPolyData> Divide(double length) const;

private:
  vtkSmartPointer<vtkPolyData> Triangles;
};

}

#endif

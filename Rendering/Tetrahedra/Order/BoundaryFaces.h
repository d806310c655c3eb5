// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_BoundaryFaces_h
#define interlume_BoundaryFaces_h

#include "Mesh/TetrahedraFields.h"
#include "Mesh/TetrahedraMesh.h"

#include "vtkType.h"

class vtkDataSet;
class vtkUnstructuredGrid;

namespace interlume
{

/**
 * @class   BoundaryFaces
 * @brief   finds the tetrahedra that boundary triangles are faces of
 *
 * A triangle is drawn with the first tetrahedron that has it as a face. Its points are the grid's
 * by their ids, or, where a filter left some out, by their exact coordinates.
 */
class BoundaryFaces
{
public:
  struct Counts
  {
    vtkIdType Triangles = 0;
    /// The number of cells that are no triangle, or no face of a tetrahedron.
    vtkIdType Unmatched = 0;
  };

  /**
   * Sets faces, normals and texture coordinates of \a fields. Normals are those of \a triangles, or
   * the mean of the triangles around a point.
   */
  static Counts Build(vtkDataSet* triangles, vtkUnstructuredGrid* grid, const TetrahedraMesh& mesh,
    TetrahedraFields& fields);

  /**
   * Removes faces, normals and texture coordinates.
   */
  static void Clear(TetrahedraFields& fields);
};

}

#endif

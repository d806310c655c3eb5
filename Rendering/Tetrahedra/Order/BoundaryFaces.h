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
 * @brief   finds the tetrahedra that have boundary triangles as faces
 *
 * A triangle is drawn with the first tetrahedron that has it as a face. Triangle points are matched
 * with grid points by id, or by exact coordinates if a filter removed points.
 */
class BoundaryFaces
{
public:
  struct Counts
  {
    vtkIdType Triangles = 0;
    /// Number of input cells that are not triangles or that are not the face of a tetrahedron.
    vtkIdType Unmatched = 0;
  };

  /**
   * Sets faces, normals and texture coordinates of \a fields. If \a triangles has no normals, point
   * normals are averaged from the adjacent triangles.
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

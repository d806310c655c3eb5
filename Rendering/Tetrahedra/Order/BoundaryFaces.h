// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_BoundaryFaces_h
#define interlume_BoundaryFaces_h

#include "Mesh/TetrahedraFields.h"
#include "Mesh/TetrahedraMesh.h"

#include "vtkType.h"

#include <map>

class vtkDataArray;
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
  /// Materials by the values of a cell array of the triangles. All others have material 0.
  struct Materials
  {
    vtkDataArray* Ids = nullptr;
    std::map<int, unsigned char> Numbers;

    bool IsEmpty() const { return !this->Ids || this->Numbers.empty(); }
    bool operator==(const Materials& other) const
    {
      return this->Ids == other.Ids && this->Numbers == other.Numbers;
    }
  };

  struct Counts
  {
    vtkIdType Triangles = 0;
    /// Number of input cells that are not triangles or that are not the face of a tetrahedron.
    vtkIdType Unmatched = 0;
  };

  /**
   * Sets faces, normals and texture coordinates of \a fields. If \a triangles has no normals, point
   * normals are averaged from the adjacent triangles. Also sets the materials of the faces if \a
   * materials is not empty.
   */
  static Counts Build(vtkDataSet* triangles, vtkUnstructuredGrid* grid, const TetrahedraMesh& mesh,
    const Materials& materials, TetrahedraFields& fields);

  /**
   * Removes faces, normals and texture coordinates.
   */
  static void Clear(TetrahedraFields& fields);
};

}

#endif

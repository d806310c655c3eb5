// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_MeshBuilder_h
#define interlume_MeshBuilder_h

#include "Common/Error.h"
#include "Mesh/TetrahedraArrays.h"
#include "Mesh/TetrahedraMesh.h"

#include "vtkType.h"

#include <vector>

class vtkUnstructuredGrid;

namespace interlume
{

/**
 * @class   MeshBuilder
 * @brief   builds the mesh to draw from a grid, and checks whether another grid gives the same mesh
 *
 * It skips ghost cells, tetrahedra without volume, and tetrahedra with NaN or infinity in their
 * coordinates or array values.
 */
class MeshBuilder
{
public:
  /**
   * Builds the mesh. Returns an error if the grid cannot be drawn; the mesh is then empty.
   */
  Error Build(vtkUnstructuredGrid* grid, const TetrahedraArrays& arrays, TetrahedraMesh& mesh);

  /**
   * Returns true if Build() would create the same mesh as \a mesh, the result of the last Build().
   * This requires the same points and cells, with finite array values at the same points and cells.
   * Values, not array pointers, are compared, because readers create new arrays for each time step.
   */
  bool IsSame(
    vtkUnstructuredGrid* grid, const TetrahedraArrays& arrays, const TetrahedraMesh& mesh) const;

  vtkIdType GetNumberOfFlatTetrahedra() const { return this->Flat; }
  vtkIdType GetNumberOfNonFiniteTetrahedra() const { return this->NonFinite; }
  std::size_t GetBytes() const { return this->BadPoints.capacity() + this->Marks.capacity(); }

private:
  /// Removes the tetrahedra that are skipped according to Marks, and counts them.
  void RemoveSkipped(TetrahedraMesh& mesh);

  /// 1 for each point with NaN or infinity in its coordinates or array values; empty if there is no
  /// such point.
  std::vector<unsigned char> BadPoints;
  /// Reason to skip each cell (0: drawn); empty if no cell is skipped.
  std::vector<unsigned char> Marks;
  vtkIdType Flat = 0;
  vtkIdType NonFinite = 0;
};

}

#endif

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
 * @brief   builds the drawn mesh from a grid, and detects whether another grid has the same mesh
 *
 * It skips tetrahedra without volume, ghost cells, and tetrahedra with NaN or infinity in a
 * coordinate or array.
 */
class MeshBuilder
{
public:
  /**
   * Builds the mesh. Returns an error if the grid cannot be drawn; the mesh is then empty.
   */
  Error Build(vtkUnstructuredGrid* grid, const TetrahedraArrays& arrays, TetrahedraMesh& mesh);

  /**
   * Returns true if Build() would create a mesh that is bit-identical to \a mesh. This is the case
   * if points and cells did not change, and the same points and cells as before have finite values.
   * It compares values, not array pointers, because readers create new arrays for each time step.
   */
  bool IsSame(
    vtkUnstructuredGrid* grid, const TetrahedraArrays& arrays, const TetrahedraMesh& mesh) const;

  vtkIdType GetNumberOfFlat() const { return this->Flat; }
  vtkIdType GetNumberOfNonFinite() const { return this->NonFinite; }
  std::size_t GetBytes() const { return this->BadPoints.capacity() + this->Marks.capacity(); }

private:
  /// Removes marked tetrahedra from the mesh and counts them.
  void RemoveSkipped(TetrahedraMesh& mesh);

  /// 1 for each point with NaN or infinity in a coordinate or array; empty if there is no such
  /// point.
  std::vector<unsigned char> BadPoints;
  /// Reason to skip each cell (0: drawn); empty if no cell is skipped.
  std::vector<unsigned char> Marks;
  vtkIdType Flat = 0;
  vtkIdType NonFinite = 0;
};

}

#endif

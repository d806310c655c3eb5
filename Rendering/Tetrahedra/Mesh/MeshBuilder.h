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
 * @brief   makes the mesh that is drawn from a grid, and tells whether another would be the same
 *
 * Tetrahedra without volume, ghosts, and those with NaN or infinity in a coordinate or array are
 * left out.
 */
class MeshBuilder
{
public:
  /**
   * Builds the mesh. Returns an error if the grid cannot be drawn; the mesh is then empty.
   */
  Error Build(vtkUnstructuredGrid* grid, const TetrahedraArrays& arrays, TetrahedraMesh& mesh);

  /**
   * Returns whether Build() would make the last mesh again to the last bit, as where only values
   * have changed and the same of them are finite. It compares numbers, not arrays: readers make
   * arrays anew for each time step.
   */
  bool IsSame(
    vtkUnstructuredGrid* grid, const TetrahedraArrays& arrays, const TetrahedraMesh& mesh) const;

  vtkIdType GetNumberOfFlat() const { return this->Flat; }
  vtkIdType GetNumberOfNonFinite() const { return this->NonFinite; }
  std::size_t GetBytes() const { return this->BadPoints.capacity() + this->Marks.capacity(); }

private:
  /// Takes what is marked out of the mesh, and counts it.
  void LeaveOut(TetrahedraMesh& mesh);

  /// The points that cannot be used are 1; empty where there are none.
  std::vector<unsigned char> BadPoints;
  /// The reason why each cell is left out; empty where none is.
  std::vector<unsigned char> Marks;
  vtkIdType Flat = 0;
  vtkIdType NonFinite = 0;
};

}

#endif

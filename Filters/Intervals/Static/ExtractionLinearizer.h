// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ExtractionLinearizer_h
#define interlume_ExtractionLinearizer_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <bitset>
#include <vector>

class vtkDataSet;
class vtkUnstructuredGrid;

namespace interlume
{

/**
 * @class   ExtractionLinearizer
 * @brief   converts a grid to an unstructured grid of cells with isotables
 *
 * A convex polyhedron with the faces of a tetrahedron, pyramid, wedge or hexahedron becomes that
 * cell. Any other polyhedron is split around a center, the mean of its vertices: each triangle
 * becomes a tetrahedron, each quadrilateral a pyramid, and each larger face a fan of tetrahedra
 * from its point with the lowest id. Shared faces are preserved, so neighbors of any type conform.
 * The value of a point array at the center is the mean over the vertices, which is exact for linear
 * fields. Documentation/methods/isotables.md explains why polyhedra with larger faces have no
 * isotable.
 *
 * Other cells without an isotable are copied, so that the extraction counts them as skipped.
 */
class ExtractionLinearizer
{
public:
  using TypeSet = std::bitset<256>;

  /// Returns the types of the cells of a dataset.
  static TypeSet FindTypes(vtkDataSet* input);

  /// Returns whether \a input is not an unstructured grid, or contains polyhedra.
  static bool IsNeeded(vtkDataSet* input);

  /// Creates the grid. \a cellIds receives the input cell of each cell, whose ghost flags the cell
  /// inherits. \a numberOfConcave receives the number of split polyhedra that are not star-shaped
  /// around their center, so that their cells overlap.
  static vtkSmartPointer<vtkUnstructuredGrid> Execute(
    vtkDataSet* input, std::vector<vtkIdType>& cellIds, vtkIdType& numberOfConcave);
};

}

#endif

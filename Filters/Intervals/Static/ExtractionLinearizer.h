// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ExtractionLinearizer_h
#define interlume_ExtractionLinearizer_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

class vtkDataSet;
class vtkUnstructuredGrid;

namespace interlume
{

/**
 * @class   ExtractionLinearizer
 * @brief   makes an unstructured grid of cells that have tables
 *
 * A convex polyhedron with the faces of a tetrahedron, pyramid, wedge or hexahedron becomes that
 * cell. Any other is coned from the mean of its vertices: a triangle gives a tetrahedron, a
 * quadrilateral a pyramid, a larger face a fan of tetrahedra from its point of lowest id. Shared
 * faces stay shared and whole, so neighbours of any type agree; the point arrays take their mean at
 * the new point, which is exact where they are linear. (The hull of a larger face's prism depends
 * on the shape of the face, so a table could not make two polyhedra agree there.)
 *
 * Cells that have no table are kept, for the extraction to count.
 */
class ExtractionLinearizer
{
public:
  /// Returns whether \a input is not an unstructured grid or has polyhedra.
  static bool IsNeeded(vtkDataSet* input);

  /// Makes the grid. \a cellIds gets the input cell of each cell made, which has the ghost level of
  /// that cell, \a numberOfConcave the number of coned polyhedra that are not seen whole from the
  /// mean of their vertices, whose parts overlap.
  static vtkSmartPointer<vtkUnstructuredGrid> Execute(
    vtkDataSet* input, std::vector<vtkIdType>& cellIds, vtkIdType& numberOfConcave);
};

}

#endif

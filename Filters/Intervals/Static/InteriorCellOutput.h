// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_InteriorCellOutput_h
#define interlume_InteriorCellOutput_h

#include "Pass/ExtractionContext.h"

class vtkUnstructuredGrid;

namespace interlume
{

/**
 * @class   InteriorCellOutput
 * @brief   writes tetrahedra and interior cells to an unstructured grid
 */
class InteriorCellOutput
{
public:
  /// Sets the cells of \a output from \a mesh, which must have interior cells and the ids of the
  /// input cells. Moves the point ids out of \a mesh.
  static void SetCells(vtkDataSet* input, ExtractionMesh& mesh, vtkUnstructuredGrid* output);
};

}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_WholeOutput_h
#define interlume_WholeOutput_h

#include "Pass/ExtractionContext.h"

class vtkUnstructuredGrid;

namespace interlume
{

/**
 * @class   WholeOutput
 * @brief   tetrahedra and cells passed on whole as the cells of an unstructured grid
 */
class WholeOutput
{
public:
  /// Gives \a output the cells of \a mesh, whose ids of cells are those of \a input, and which has
  /// whole cells. Takes the ids out of \a mesh.
  static void SetCells(vtkDataSet* input, ExtractionMesh& mesh, vtkUnstructuredGrid* output);
};

}

#endif

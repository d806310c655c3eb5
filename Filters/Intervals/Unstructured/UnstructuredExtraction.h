// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_UnstructuredExtraction_h
#define interlume_UnstructuredExtraction_h

#include "Pass/ExtractionContext.h"

class vtkUnstructuredGrid;

namespace interlume
{

/**
 * @class   UnstructuredExtraction
 * @brief   extraction from any mixture of tetrahedra, pyramids, wedges, hexahedra and voxels
 *
 * Every cell with output enters each of its edge crossings in the list of the crossing's owner,
 * which is the end of the edge with the lower id. The lists are sorted and contain no duplicates. A
 * prefix sum over the owners numbers the output points. The numbers depend on the grid only, not on
 * the thread schedule. If the grid's points are numbered row by row, the numbers equal those of
 * StructuredExtraction.
 *
 * Shared faces are cut in the order of the global point ids if the point data has them, so that the
 * pieces of a distributed grid match. Otherwise they are cut in the order of the point ids.
 */
class UnstructuredExtraction
{
public:
  /// Runs the extraction. \a grid must be the input of the context. Returns false if the user
  /// aborted.
  static bool Execute(
    const ExtractionContext& context, vtkUnstructuredGrid* grid, ExtractionMesh& mesh);
};

}

#endif

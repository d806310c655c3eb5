// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_UnstructuredExtraction_h
#define interlume_UnstructuredExtraction_h

#include "Pass/ExtractionContext.h"

class vtkUnstructuredGrid;

namespace interlume
{

/**
 * @class   UnstructuredExtraction
 * @brief   extraction from tetrahedra, pyramids, wedges, hexahedra and voxels in any mixture
 *
 * Every cell that gives output enters the crossed edges it uses with the lower of their two points,
 * their owner. Each owner's list is sorted and made unique; a prefix sum over the owners numbers
 * the output points. The numbers, and so the bytes, depend on the grid alone; on a grid whose
 * points are numbered in rows they are those of StructuredExtraction.
 *
 * The order in which shared faces are cut is that of the global point ids where the point data has
 * them, so that distributed pieces of a grid agree, and of the point ids otherwise.
 */
class UnstructuredExtraction
{
public:
  /// Runs the extraction. Returns false when the user aborted. The context's input is \a grid.
  static bool Execute(
    const ExtractionContext& context, vtkUnstructuredGrid* grid, ExtractionMesh& mesh);
};

}

#endif

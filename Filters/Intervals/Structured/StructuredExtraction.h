// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_StructuredExtraction_h
#define interlume_StructuredExtraction_h

#include "Pass/ExtractionContext.h"

namespace interlume
{

/**
 * @class   StructuredExtraction
 * @brief   extraction from a grid of rows, where a point's id is arithmetic on its edge
 *
 * A grid point owns itself and the edges that leave it along +i, +j, +k. Output points are numbered
 * by owner; a first pass over the rows counts the points that a row owns and the simplices that a
 * row of cells gives, a prefix sum gives every row its place, a second pass writes. Nothing is
 * shared between rows, so the bytes do not depend on the threads.
 */
class StructuredExtraction
{
public:
  /// Runs the extraction, with other pieces' cells where one of them is tied: see GhostCells.
  /// Returns false when the user aborted.
  static bool Execute(ExtractionContext& context, const int dimensions[3], ExtractionMesh& mesh);
};

}

#endif

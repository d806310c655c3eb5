// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_StructuredExtraction_h
#define interlume_StructuredExtraction_h

#include "Pass/ExtractionContext.h"

namespace interlume
{

/**
 * @class   StructuredExtraction
 * @brief   extraction from a structured grid, without searching for points that cells share
 *
 * A grid point owns the output points on itself and its edges along +i, +j and +k. Output points
 * are numbered by owner. The first pass counts the points that each row owns and the simplices of
 * each row of cells. A prefix sum computes the start position of each row, and the second pass
 * writes the output. Rows share no data, so the output is independent of the number of threads.
 */
class StructuredExtraction
{
public:
  /// Runs the extraction. Ghost cells are extracted too if one of them has a tie (see GhostCells).
  /// Returns false if the user aborted.
  static bool Execute(ExtractionContext& context, const int dimensions[3], ExtractionMesh& mesh);
};

}

#endif

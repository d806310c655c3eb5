// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RowContour_h
#define interlume_RowContour_h

#include "Grid/GridWindow.h"
#include "Pass/ExtractionContext.h"

namespace interlume
{

/**
 * @class   RowContour
 * @brief   the contour of one value in image data, rectilinear and structured grids
 *
 * It gives what StructuredExtraction gives for any values, byte by byte, from one bit a grid point:
 * which cells the surface meets and how many points each row owns are counted in words, and ids run
 * along a row. Where no value equals the isovalue, coordinates and arrays are made row by row, and
 * there is no list of points.
 */
class RowContour
{
public:
  /// Returns whether an extraction is one. Its window has no blanked cells.
  static bool IsSuited(const ExtractionContext& context);

  /// Extracts the cells of a window. Returns false when the user aborted.
  static bool Execute(ExtractionContext& context, const int dimensions[3], const GridWindow& window,
    ExtractionMesh& mesh);
};

}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RowContour_h
#define interlume_RowContour_h

#include "Grid/GridCellRange.h"
#include "Pass/ExtractionContext.h"

namespace interlume
{

/**
 * @class   RowContour
 * @brief   contour of one value in image data, rectilinear and structured grids
 *
 * The output is identical to that of StructuredExtraction, but the extraction is faster. Comparing
 * the values with the isovalue gives one bit per grid point. Bit operations on words then find the
 * cells that the surface intersects and the number of points that each row owns. Point ids are
 * consecutive along a row. If no value equals the isovalue, coordinates and arrays are computed row
 * by row, without a list of points.
 */
class RowContour
{
public:
  /// Returns true if this class can run the extraction. The window must not have blanked cells.
  static bool IsApplicable(const ExtractionContext& context);

  /// Extracts the cells of a window. Returns false if the user aborted.
  static bool Execute(ExtractionContext& context, const int dimensions[3],
    const GridCellRange& window, ExtractionMesh& mesh);
};

}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SimplexSlicer_h
#define interlume_SimplexSlicer_h

#include "Pass/ExtractionContext.h"

class vtkUnstructuredGrid;

namespace interlume
{

/**
 * @class   SimplexSlicer
 * @brief   tetrahedral contour of a grid of 4-simplices at one value
 *
 * The cells are processed in chunks, which are first counted and then written. A vertex at the
 * slice value counts as above, and an edge crossing at such a vertex is the vertex itself. Thus the
 * slice is the limit of the slices just below the value, without collapsed tetrahedra. This limit
 * misses a 4-simplex that has four vertices at the value and one above. The tetrahedron of the four
 * vertices is added, unless a 4-simplex of the same interval that ends at the value already
 * contributes it. In slices at a time, the cell array AtStep marks 4-simplices that contribute no
 * tetrahedra at a step, and cells that are themselves tetrahedra at a step, which are added as
 * well.
 *
 * Points are numbered as in UnstructuredExtraction, so the output depends only on the grid.
 */
class SimplexSlicer
{
public:
  struct Options
  {
    /// Whether the scalars are times, to which AtStep refers.
    bool IsAtTime;
    /// Whether the coordinates of the output have the opposite orientation.
    bool IsMirrored;
  };

  struct Slice
  {
    ExtractionBuffer<ExtractionPoint> Points;
    SimplexList Tetrahedra;
    /// The cell id of each tetrahedron, if the context requests cell ids.
    ExtractionBuffer<vtkIdType> CellIds;
    /// Id of the first cell that is not a VTK_POLY_VERTEX with five points, or -1. If such a cell
    /// exists, there is no slice.
    vtkIdType InvalidCell = -1;
    /// Number of cells skipped because a time or a coordinate is NaN or infinite.
    vtkIdType NonFiniteCells = 0;
  };

  /// Computes the slice. \a context must have one contour value and \a grid as input. Returns false
  /// if the user aborted.
  static bool Execute(const ExtractionContext& context, vtkUnstructuredGrid* grid,
    const Options& options, Slice& slice);
};

}

#endif

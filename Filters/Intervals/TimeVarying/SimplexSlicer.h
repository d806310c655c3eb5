// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SimplexSlicer_h
#define interlume_SimplexSlicer_h

#include "Pass/ExtractionContext.h"

class vtkUnstructuredGrid;

namespace interlume
{

/**
 * @class   SimplexSlicer
 * @brief   the contour of one value in a grid of 4-simplices, as tetrahedra
 *
 * Cells are counted first and then written, in chunks. A vertex at the value itself is above, and a
 * crossing at the end of its edge is that vertex: the slice is the limit of those below the value,
 * less what has collapsed there. That misses a 4-simplex that begins at the value with four of its
 * vertices; the tetrahedron of these is added, unless a 4-simplex of the same interval that ends
 * there has given it. The cell array AtStep tells of 4-simplices that give nothing there, and of
 * tetrahedra, which are added likewise.
 *
 * Points are numbered as by UnstructuredExtraction: the bytes depend on the grid alone.
 */
class SimplexSlicer
{
public:
  struct Slice
  {
    ExtractionBuffer<ExtractionPoint> Points;
    SimplexList Tetrahedra;
    /// The cell of each tetrahedron, where the context keeps them.
    ExtractionBuffer<vtkIdType> CellIds;
    /// The first cell that is no VTK_POLY_VERTEX of five points, because of which there is no
    /// slice; -1 for none.
    vtkIdType InvalidCell = -1;
    /// The number of cells skipped because a time or a coordinate is NaN or infinite.
    vtkIdType NonFiniteCells = 0;
  };

  /// Makes the slice. Returns false when the user aborted. The contour of \a context has one value,
  /// its input is \a grid.
  static bool Execute(const ExtractionContext& context, vtkUnstructuredGrid* grid, Slice& slice);
};

}

#endif

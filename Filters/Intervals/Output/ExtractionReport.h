// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ExtractionReport_h
#define interlume_ExtractionReport_h

#include "vtkType.h"

#include <vector>

class vtkInterlumeReport;

namespace interlume
{

/**
 * @class   ExtractionReport
 * @brief   report of vtkIntervalVolume and vtkIsotableContour
 *
 * The sum over the leaves of a composite dataset. A coned polyhedron counts by its parts in all
 * numbers of cells except Cells.
 */
struct ExtractionReport
{
  /// The number of cells of the input.
  vtkIdType Cells = 0;
  /// The number of cells whose values were read; the others were skipped by the index of value
  /// ranges.
  vtkIdType CellsVisited = 0;
  /// The number of cells that were compared as bits, which is faster: cells of image data,
  /// rectilinear and structured grids in a contour of one value, if no cell or point is blanked,
  /// hidden or a ghost, except for layers of ghost cells around a piece. The index of value ranges
  /// then skips whole rows.
  vtkIdType CellsByBits = 0;
  /// The number of cells of the input that gave at least one simplex.
  vtkIdType CellsWithOutput = 0;
  /// The number of cells skipped because they have fewer than three dimensions.
  vtkIdType LowerDimensionalCells = 0;
  /// Number of cells skipped because a value or a coordinate of a corner is NaN or infinite.
  vtkIdType NonFiniteCells = 0;
  /// The number of cells skipped because they, or one of their points, are blanked, hidden or a
  /// ghost.
  vtkIdType BlankedCells = 0;
  /// The number of quadratic and higher cells taken as their linear counterpart.
  vtkIdType LinearizedCells = 0;
  /// The number of coned polyhedra whose parts overlap, since the mean of their points does not
  /// see every face.
  vtkIdType ConcavePolyhedra = 0;
  /// The number of cells of a type that has no three-dimensional linear counterpart.
  vtkIdType UnsupportedCells = 0;
  /// The number of cells with output that are folded: their Jacobian is positive at some corners
  /// and negative at others, as in hexahedra with the point order of voxels, which cross
  /// themselves. And the number of cells of rectilinear grids where coordinates turn back or
  /// repeat.
  vtkIdType FoldedCells = 0;
  /// Of an AMR input, the number of cells that give output although cells of a finer level lie over
  /// them, since they are not blanked; and the number of faces between cells of two levels that an
  /// isovalue crosses, where the surfaces of the levels end apart.
  vtkIdType CoveredCells = 0;
  vtkIdType LevelFaces = 0;
  /// The number of simplices of the tables' cases not emitted since values equal a bound, or
  /// corners of a cell are one point: they have no volume.
  vtkIdType CollapsedSimplices = 0;
  /// The number of cells passed on whole, and of non-planar quadrilaterals between such a cell and
  /// tetrahedra of its interval: there a line of sight may find a gap or an overlap as thick as the
  /// face is bent. 0 without KeepWholeCells.
  vtkIdType InteriorCells = 0;
  vtkIdType NonPlanarFaces = 0;
  /// The numbers of point arrays interpolated (coordinates not counted) and of cell arrays copied.
  int ArraysInterpolated = 0;
  int ArraysCopied = 0;
  /// The number of passes over a mesh: 1, and one more for each further criterion.
  int Passes = 0;
  /// The largest number of bytes of working memory held, input and output not counted.
  vtkIdType WorkingBytes = 0;
  /// With KeepMemory: the number of bytes of retained blocks that the execution reused for outputs
  /// and working memory, and of blocks that were unused at its end. Blocks of less than 64 KiB are
  /// not retained.
  vtkIdType ReusedBytes = 0;
  vtkIdType IdleBytes = 0;
  /// The number of cells with output of each process, if the filter's ReportBalance is on and each
  /// process extracts its piece. Empty otherwise.
  std::vector<vtkIdType> CellsPerProcess;

  /// Returns the largest number of cells with output of one process divided by the mean over all
  /// processes, or 0 if CellsPerProcess is empty or has only zeros. 1 is an even balance.
  double GetBalance() const;

  /// Adds the counts of cells and simplices; keeps the larger of the other numbers.
  void Add(const ExtractionReport& other);
  /// Copies all values, and Balance.
  void CopyTo(vtkInterlumeReport* report) const;
};

}

#endif

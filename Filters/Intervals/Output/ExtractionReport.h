// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ExtractionReport_h
#define interlume_ExtractionReport_h

#include "vtkType.h"

#include <string>
#include <vector>

class vtkInterlumeReport;

namespace interlume
{

/**
 * @class   ExtractionReport
 * @brief   report of vtkIntervalVolume and vtkIsotableContour
 *
 * For a composite dataset, the report covers all leaves. A polyhedron or polygon that is split into
 * parts counts as one cell in Cells. In the other cell counts, each part counts as a cell.
 */
struct ExtractionReport
{
  /// Number of input cells.
  vtkIdType Cells = 0;
  /// Number of cells whose values were read. The value range index skipped all other cells.
  vtkIdType CellsVisited = 0;
  /// Number of cells classified with bit operations, which is faster. This applies to contours of
  /// one value in image data, rectilinear grids and structured grids if no cell or point is
  /// blanked, hidden or a ghost, except for layers of ghost cells around a piece. The value range
  /// index then skips full rows.
  vtkIdType CellsByBits = 0;
  /// Number of input cells that produced at least one simplex.
  vtkIdType CellsWithOutput = 0;
  /// Number of cells skipped because they have fewer than three dimensions, or fewer than two if
  /// two-dimensional cells are extracted.
  vtkIdType LowerDimensionalCells = 0;
  /// Number of cells skipped because a point has a NaN or infinite scalar or coordinate.
  vtkIdType NonFiniteCells = 0;
  /// Number of cells skipped because the cell or one of its points is blanked, hidden or a ghost.
  vtkIdType BlankedCells = 0;
  /// Number of quadratic and higher-order cells treated as linear.
  vtkIdType LinearizedCells = 0;
  /// Number of split polyhedra whose parts overlap because some faces are not visible from the mean
  /// of the polyhedron's points.
  vtkIdType ConcavePolyhedra = 0;
  /// Number of cells skipped because their type has no three-dimensional linear counterpart.
  vtkIdType UnsupportedCells = 0;
  /// Number of folded cells with output. The Jacobian of a folded cell is positive at some corners
  /// and negative at others, for example in a hexahedron with the point order of a voxel. In a
  /// rectilinear grid, cells are folded where coordinates repeat or reverse direction.
  vtkIdType FoldedCells = 0;
  /// For AMR input: number of cells with output that are not blanked although finer cells cover
  /// them, and number of faces between two levels that an isovalue crosses. At such faces, the
  /// surfaces of the two levels do not meet.
  vtkIdType CoveredCells = 0;
  vtkIdType LevelFaces = 0;
  /// Number of simplices of table cases that were omitted because they are degenerate, where values
  /// equal a bound or points of a cell coincide.
  vtkIdType CollapsedSimplices = 0;
  /// Number of cells inside an interval that are copied uncut, and number of non-planar
  /// quadrilaterals between such a cell and tetrahedra of the same interval. At a non-planar face,
  /// a view ray may encounter a gap or an overlap. Both are 0 if KeepInteriorCells is off.
  vtkIdType InteriorCells = 0;
  vtkIdType NonPlanarFaces = 0;
  /// Number of interpolated point arrays (excluding coordinates) and of copied cell arrays.
  int ArraysInterpolated = 0;
  int ArraysCopied = 0;
  /// Number of passes over a mesh: 1, plus one for each additional criterion.
  int Passes = 0;
  /// Peak size of the working memory in bytes, excluding input and output.
  vtkIdType WorkingBytes = 0;
  /// If ReuseMemory is on: number of bytes in pooled blocks that this execution reused for outputs
  /// and working memory, and size in bytes of the blocks that are idle at its end. Blocks below 64
  /// KiB are not pooled.
  vtkIdType ReusedBytes = 0;
  vtkIdType IdleBytes = 0;
  /// Number of cells with output per process if the filter's ReportBalance is on and each process
  /// extracts its own piece. Empty otherwise.
  std::vector<vtkIdType> CellsPerProcess;
  /// Names of the cell arrays that were averaged at the points.
  std::vector<std::string> ConvertedCellArrays;

  /// Returns the load balance: the maximum number of cells with output per process, divided by the
  /// mean over all processes. 1 is perfect balance. Returns 0 if CellsPerProcess is empty or all
  /// zeros.
  double GetBalance() const;

  /// Adds the numbers of cells, faces and simplices. Takes the maximum of the other values, except
  /// CellsPerProcess and ConvertedCellArrays, which are unchanged.
  void Add(const ExtractionReport& other);
  /// Copies all values and the balance to \a report.
  void CopyTo(vtkInterlumeReport* report) const;
};

}

#endif

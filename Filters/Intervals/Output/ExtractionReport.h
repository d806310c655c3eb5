// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkExtractionReport_h
#define vtkExtractionReport_h

#include "InterlumeIntervalsModule.h" // for the export macro
#include "vtkIndent.h"
#include "vtkType.h"

#include <vector> // for what each process did

/**
 * @class   vtkExtractionReport
 * @brief   what the last execution of an extraction filter did
 *
 * This is a plain value object, summed over the leaves of a composite dataset. Every count is 0
 * before the first execution. A polyhedron that is coned counts by its parts in all numbers of
 * cells but Cells.
 *
 * @sa vtkIntervalVolume vtkIsotableContour
 */
struct INTERLUMEINTERVALS_EXPORT vtkExtractionReport
{
  /// The number of cells of the input.
  vtkIdType Cells = 0;
  /// The number of cells whose values were read; the others were skipped by the index of value
  /// ranges.
  vtkIdType CellsVisited = 0;
  /// The number of cells that were compared as bits, which is quicker: those of image data,
  /// rectilinear and structured grids in a contour of one value, where no cell or point is blanked,
  /// hidden or a ghost, but for layers of ghost cells around a piece. There the index of value
  /// ranges skips whole rows.
  vtkIdType CellsByBits = 0;
  /// The number of cells of the input that gave at least one simplex.
  vtkIdType CellsWithOutput = 0;
  /// The number of cells left out because they have fewer than three dimensions.
  vtkIdType LowerDimensionalCells = 0;
  /// Number of cells skipped because a value or a coordinate of a corner is NaN or infinite.
  vtkIdType NonFiniteCells = 0;
  /// The number of cells left out because they, or one of their points, are blanked, hidden or a
  /// ghost.
  vtkIdType BlankedCells = 0;
  /// The number of quadratic and higher cells taken as their linear counterpart.
  vtkIdType LinearizedCells = 0;
  /// The number of polyhedra that are coned and that the mean of their points does not see whole:
  /// their parts overlap.
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
  /// The number of cells passed on whole, and of quadrilaterals, not planar, where such a cell
  /// meets tetrahedra of its interval: there a line of sight may find a gap or an overlap as thick
  /// as the face is bent. 0 without KeepWholeCells.
  vtkIdType WholeCells = 0;
  vtkIdType WarpedFaces = 0;
  /// The numbers of point arrays interpolated (coordinates not counted) and of cell arrays copied.
  int ArraysInterpolated = 0;
  int ArraysCopied = 0;
  /// The number of passes over a mesh: 1, and one more for each further criterion.
  int Passes = 0;
  /// The largest number of bytes of working memory held, input and output not counted.
  vtkIdType WorkingBytes = 0;
  /// With KeepMemory: the number of bytes of blocks used before that the execution has used again,
  /// output and working memory, and of blocks that nobody held at its end. Blocks of less than 64
  /// KiB are not kept.
  vtkIdType ReusedBytes = 0;
  vtkIdType IdleBytes = 0;
  /// Of processes that each extract their piece, where the filter's ReportBalance is on: the number
  /// of cells with output of each, the same in all of them. Empty where it is off, and for one
  /// process.
  std::vector<vtkIdType> CellsOfRanks;

  /// Returns the most cells with output that one process has over the mean of all: 1 where all have
  /// as many, the number of processes where one has all; 0 where none has any, or nothing is known.
  double GetBalance() const;

  /// Adds the counts of cells and simplices; keeps the larger of the other numbers.
  void Add(const vtkExtractionReport& other);
  void Print(ostream& os, vtkIndent indent) const;
};

#endif

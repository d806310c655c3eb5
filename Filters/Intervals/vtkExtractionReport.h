#ifndef vtkExtractionReport_h
#define vtkExtractionReport_h

#include "InterlumeIntervalsModule.h" // for the export macro
#include "vtkIndent.h"
#include "vtkType.h"

/**
 * @class   vtkExtractionReport
 * @brief   what the last execution of an extraction filter did
 *
 * A plain value object, summed over the leaves of a composite dataset. Every count is 0 before the
 * first execution. A polyhedron that is coned counts by its parts in all numbers of cells but
 * Cells.
 *
 * @sa vtkIntervalVolume vtkIsotableContour
 */
struct INTERLUMEINTERVALS_EXPORT vtkExtractionReport
{
  /// Cells of the input.
  vtkIdType Cells = 0;
  /// Cells whose values were read; the others were skipped by the index of value ranges.
  vtkIdType CellsVisited = 0;
  /// Cells of the input that gave at least one simplex.
  vtkIdType CellsWithOutput = 0;
  /// Cells left out because they have fewer than three dimensions.
  vtkIdType LowerDimensionalCells = 0;
  /// Cells left out because a value at a corner is NaN or infinite.
  vtkIdType NonFiniteCells = 0;
  /// Cells left out because they, or one of their points, are blanked, hidden or a ghost.
  vtkIdType BlankedCells = 0;
  /// Quadratic and higher cells taken as their linear counterpart.
  vtkIdType LinearizedCells = 0;
  /// Polyhedra that are coned and that the mean of their points does not see whole: their parts
  /// overlap.
  vtkIdType ConcavePolyhedra = 0;
  /// Cells of a type that has no three-dimensional linear counterpart.
  vtkIdType UnsupportedCells = 0;
  /// Simplices of the tables' cases not emitted since values equal a bound, or corners of a cell
  /// are one point: they have no volume.
  vtkIdType CollapsedSimplices = 0;
  /// Point arrays interpolated (coordinates not counted) and cell arrays copied.
  int ArraysInterpolated = 0;
  int ArraysCopied = 0;
  /// Passes over a mesh: 1, and one more for each further criterion.
  int Passes = 0;
  /// Bytes of working memory held at most, input and output not counted.
  vtkIdType WorkingBytes = 0;

  /// Adds the counts of cells and simplices; of the other numbers the larger stays.
  void Add(const vtkExtractionReport& other);
  void Print(ostream& os, vtkIndent indent) const;
};

#endif

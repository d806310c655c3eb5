// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkIntervalVolume_h
#define vtkIntervalVolume_h

#include "InterlumeIntervalsModule.h" // for the export macro
#include "vtkInterlumeDeprecation.h"
#include "vtkInterlumeReport.h" // for GetReport()
#include "vtkIntervalAlgorithm.h"
#include "vtkNew.h"          // for the report
#include "vtkSmartPointer.h" // for the value index

#include <memory> // for the block pool
#include <string> // for messages

class vtkDataArray;
class vtkDataSet;

namespace interlume
{
class Error;
class ExtractionIndex;
class ExtractionRun;
class BlockPool;
struct ExtractionReport;
struct InteriorCellPass;
}

/**
 * @class   vtkIntervalVolume
 * @brief   extract the region between two isovalues as tetrahedra or triangles
 *
 * Extracts the interval volume { x : lower <= f(x) <= upper } of a scalar array, for any number of
 * intervals. Each cell is lifted by one dimension, its isosurface is looked up in an isotable and
 * projected back. Tetrahedra of adjacent cells conform, even if the cells have different types. See
 * Documentation/methods/interval-volumes.md and, for timings, Documentation/measurements.md.
 *
 * Input: vtkImageData, vtkRectilinearGrid, vtkStructuredGrid, vtkPolyData, vtkUnstructuredGrid with
 * tetrahedra, voxels, hexahedra, wedges, pyramids, convex polyhedra and polygons, and composite
 * datasets of these. Quadratic cells are treated as linear, with a warning. A concave polyhedron
 * produces overlapping tetrahedra, with a warning. Cells are skipped, and counted in GetReport(),
 * if they have fewer than two dimensions, are ghost, hidden or blanked, or if a corner has a NaN or
 * infinite scalar or coordinate. For the scalar, and for cell arrays, see vtkIntervalAlgorithm.
 *
 * Output port 0: VTK_TETRA cells in a vtkUnstructuredGrid. A composite input produces a composite
 * output of the same structure. Arrays:
 * - every point array, interpolated linearly along grid edges. Integers become float (8 and 16
 *   bits) or double. The processed array is the active scalars.
 * - every cell array, copied from the input cell
 * - cell array `IntervalId` (int): the index of the interval; see also CriteriaOperation
 *
 * Output port 1, if GenerateBoundaries is on: the triangles where f equals a bound, oriented
 * outward from their interval. They use the points and point ids of port 0 and have its point
 * arrays, the cell arrays above, and the cell array `BoundarySide` (int; 0 lower, 1 upper).
 *
 * Two-dimensional cells become VTK_TRIANGLE cells with the orientation of the cell, and VTK_LINE
 * cells at the boundary, with the interval to their left. If there are three-dimensional cells too,
 * the triangles and lines follow the other cells and do not share points with them. Strips, concave
 * quadrilaterals and polygons with more than four corners are split into triangles first.
 *
 * Values equal to a bound: f = lower is inside. f = upper is inside unless another interval of
 * nonzero width starts at that value. Adjacent intervals of one filter therefore tile the domain
 * without gaps or overlap. The interval [a, a] consists of the cells whose corners are all equal to
 * a. Adjacent intervals share the points on their common boundary.
 *
 * Interior cells: with KeepInteriorCells, a cell that lies inside an interval and satisfies all
 * criteria is copied instead of cut. Port 0 then has the tetrahedra first, followed by these cells,
 * both in input order. Two-dimensional cells are cut. Interior cells of image data and rectilinear
 * grids are voxels, or hexahedra if the image is rotated. A copied cell has quadrilateral faces
 * where its cut neighbor has two triangles, so a face that is not planar may leave a gap or an
 * overlap; see NonPlanarFaces of GetReport().
 *
 * Distributed grids: unstructured partitions need global point ids of any integer type, so that
 * faces between partitions match. The filter requests one layer of ghost cells, which produce no
 * output. The outputs of all partitions together are then bit-identical to the extraction of the
 * full grid. The result does not depend on the number of threads.
 *
 * Errors (vtkErrorMacro, empty output): a missing or invalid scalar or criterion array, lower >
 * upper, a bound that is not finite, invalid global ids, or a malformed cell.
 *
 * Warnings (vtkWarningMacro), for each dataset: quadratic cells, concave polyhedra, folded cells,
 * NaN or infinite coordinates, and non-monotonic coordinates of a rectilinear grid. Further
 * warnings report single-precision points too far from the origin, and AMR levels that overlap or
 * meet at a face that an isovalue intersects. An empty or large output causes one warning for all
 * datasets, see WarnOnEmptyOutput and SizeWarningLimit.
 *
 * @sa vtkIsotableContour vtkTimeVaryingIntervalVolume vtkIsotable
 */
class INTERLUMEINTERVALS_EXPORT vtkIntervalVolume : public vtkIntervalAlgorithm
{
public:
  static vtkIntervalVolume* New();
  vtkTypeMacro(vtkIntervalVolume, vtkIntervalAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum BoundarySides
  {
    LOWER_SIDE = 0,
    UPPER_SIDE = 1
  };

  ///@{
  /**
   * If true, generate the boundary triangles on port 1. With criteria, this includes the triangles
   * where the array of a criterion equals its bound. Their `BoundarySide` is 2 i + 2 at the lower
   * and 2 i + 3 at the upper bound of criterion i, counted from 0. With UNION, the boundary of each
   * interval is complete, and the triangles of a criterion are those outside of the intervals and
   * of earlier criteria. On a face between the pieces of a distributed grid, a triangle of a
   * criterion may be missing or superfluous if the criterion's array equals the bound there.
   * Default off.
   */
  vtkSetMacro(GenerateBoundaries, bool);
  vtkGetMacro(GenerateBoundaries, bool);
  vtkBooleanMacro(GenerateBoundaries, bool);
  ///@}

  ///@{
  /**
   * If true, copy three-dimensional cells that lie inside an interval and satisfy all criteria, and
   * cut only the other cells. With UNION, cells inside an interval are copied, and the tetrahedra
   * of criteria follow them. With DIFFERENCE and criteria, all cells are cut. Default off.
   */
  vtkSetMacro(KeepInteriorCells, bool);
  vtkGetMacro(KeepInteriorCells, bool);
  vtkBooleanMacro(KeepInteriorCells, bool);
  interlumeDeprecatedBooleanMacro(KeepWholeCells, KeepInteriorCells);
  ///@}

  ///@{
  /**
   * If true, add arrays that give the origin of the output: point arrays `OriginPoints`
   * (vtkIdType, 2 components: the ends of the grid edge, which are equal for a grid point) and
   * `OriginWeight` (double, 0 to 1/2: the relative distance from the first end), and cell array
   * `OriginCell` (vtkIdType, on both ports). A polyhedron that is split around its center has an
   * additional point, whose id follows the ids of the input's points. This setting is ignored if
   * there are criteria. Default off.
   */
  vtkSetMacro(GenerateOriginArrays, bool);
  vtkGetMacro(GenerateOriginArrays, bool);
  vtkBooleanMacro(GenerateOriginArrays, bool);
  interlumeDeprecatedBooleanMacro(KeepOrigins, GenerateOriginArrays);
  ///@}

  ///@{
  /**
   * If true, keep an index of value ranges between executions, so that after the intervals change,
   * only cells with values near them are visited. The index is built when the intervals change for
   * the first time while the input stays the same. Default on.
   */
  vtkSetMacro(UseValueIndex, bool);
  vtkGetMacro(UseValueIndex, bool);
  vtkBooleanMacro(UseValueIndex, bool);
  ///@}

  ///@{
  /**
   * If true, reuse large blocks of released memory (working memory and former outputs) in the next
   * execution, since clearing new pages takes a large part of the time of each update. Useful while
   * a user drags an interval. The setting does not change the result. An output remains valid as
   * long as it is referenced. Blocks that two successive executions did not use are freed. All
   * blocks are freed when the filter executes with this setting off or is deleted. Default off.
   */
  vtkSetMacro(ReuseMemory, bool);
  vtkGetMacro(ReuseMemory, bool);
  vtkBooleanMacro(ReuseMemory, bool);
  interlumeDeprecatedBooleanMacro(KeepMemory, ReuseMemory);
  ///@}

  ///@{
  /**
   * When to extract two-dimensional cells: never, only from a dataset without three-dimensional
   * cells, or always. The polygons of a mesh with both are often its boundary, and
   * vtkTimeWeightedTetrahedraMapper does not accept their triangles. Default WITHOUT_SOLIDS.
   */
  enum SurfaceCellModes
  {
    NEVER,
    WITHOUT_SOLIDS,
    ALWAYS
  };
  vtkSetClampMacro(SurfaceCells, int, NEVER, ALWAYS);
  vtkGetMacro(SurfaceCells, int);
  ///@}

  /**
   * Return the report of the last execution:
   * - Cells, CellsWithOutput: number of input cells, and of cells with output before criteria
   * - BlankedCells: cells skipped because the cell or one of its points is blanked, hidden or a
   *   ghost
   * - NonFiniteCells: cells skipped because a value or a coordinate is NaN or infinite
   * - LowerDimensionalCells, UnsupportedCells: cells skipped because of their type. Polygons
   *   count as lower-dimensional if SurfaceCells excludes them.
   * - LinearizedCells: quadratic and higher-order cells treated as linear
   * - ConcavePolyhedra: polyhedra whose tetrahedra overlap
   * - FoldedCells: self-intersecting cells with output
   * - NonPlanarFaces: quadrilaterals where KeepInteriorCells may leave a gap or an overlap
   * - ConvertedCellArrays: names of the cell arrays that were averaged at the points
   */
  vtkInterlumeReport* GetReport() { return this->Report; }

  /// Return the value NonFiniteCells of the report.
  vtkIdType GetNumberOfNonFiniteCells() { return this->Report->GetCount("NonFiniteCells"); }

protected:
  vtkIntervalVolume();
  ~vtkIntervalVolume() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkIntervalVolume(const vtkIntervalVolume&) = delete;
  void operator=(const vtkIntervalVolume&) = delete;

  /// Returns an error if an interval or a criterion is invalid.
  interlume::Error CheckParameters(vtkDataSet* input) const;
  /// Extracts the intervals from one dataset.
  void ExtractFrom(vtkDataSet* input, interlume::ExtractionRun& run, vtkUnstructuredGrid* output,
    vtkUnstructuredGrid* boundary);
  /// Extracts the intervals, combined with the criteria, from the cells of one dimension. \a
  /// isMixed is true if cells of the other dimension are extracted too. Returns false if the user
  /// aborted.
  bool ExtractCells(int dimension, bool isMixed, vtkDataSet* input, vtkDataArray* scalars,
    interlume::ExtractionRun& run, vtkUnstructuredGrid* output, vtkUnstructuredGrid* boundary);
  /// Runs the first pass. \a whole is null if interior cells are cut too. Returns false if the user
  /// aborted.
  bool ExtractIntervals(int dimension, bool isMixed, vtkDataSet* input, vtkDataArray* scalars,
    interlume::ExtractionRun& run, interlume::InteriorCellPass* whole, vtkUnstructuredGrid* output,
    vtkUnstructuredGrid* boundary);
  /// Extracts the region outside of the intervals that satisfies any criterion, and appends it to
  /// the outputs. Returns false if the user aborted.
  bool AppendCriteria(int dimension, vtkDataSet* input, vtkDataArray* scalars,
    interlume::ExtractionRun& run, vtkUnstructuredGrid* output, vtkUnstructuredGrid* boundary);
  /// Cuts the previous result by one criterion. Keeps the part that does not satisfy it if \a
  /// isInverted is true. Returns false if the user aborted.
  bool ApplyCriterion(int dimension, int number, bool isInverted, interlume::ExtractionRun& run,
    interlume::InteriorCellPass* whole, vtkUnstructuredGrid* grid, vtkUnstructuredGrid* boundary);
  /// Starts the next of the passes, which share the progress range.
  void StartPass(const std::string& text);

  ///@{
  /// Start and end the use of the block pool in an execution.
  void BeginMemory();
  void EndMemory(interlume::ExtractionReport& report);
  ///@}

  bool GenerateBoundaries = false;
  bool KeepInteriorCells = false;
  bool GenerateOriginArrays = false;
  bool UseValueIndex = true;
  bool ReuseMemory = false;
  int SurfaceCells = WITHOUT_SOLIDS;
  vtkNew<vtkInterlumeReport> Report;
  vtkSmartPointer<interlume::ExtractionIndex> Index;
  /// Null if memory reuse is off.
  std::unique_ptr<interlume::BlockPool> Memory;
};

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkIsotableContour_h
#define vtkIsotableContour_h

#include "InterlumeIntervalsModule.h" // for the export macro
#include "vtkInterlumeReport.h"       // for GetReport()
#include "vtkNew.h"                   // for the report
#include "vtkSmartPointer.h"          // for the value index
#include "vtkUnstructuredGridAlgorithm.h"

#include <vector> // for the values

class vtkDataSet;

namespace interlume
{
class Error;
class ExtractionIndex;
class ExtractionRun;
}

/**
 * @class   vtkIsotableContour
 * @brief   isosurfaces of any dataset from convex-hull case tables
 *
 * The isosurface f = v of a scalar point array is made cell by cell from an isotable: the facets of
 * the convex hull of a cell's positive vertices and the midpoints of its edges that change sign
 * (P. Bhaniramka, R. Wenger, R. Crawfis, "Isosurface construction in any dimension using convex
 * hulls", IEEE TVCG 10(2), 2004). A vertex is positive when f >= v. Facets with more than three
 * points are cut in one global order of the grid's point ids, so that any two cells agree on the
 * edge they share: the surface has no cracks, in mixed meshes too. No triangle is there turned over
 * as well: a face of two cells that equals v throughout, lower values on both sides, has none. In a
 * face of the domain it has.
 *
 * Input: any dataset or composite dataset, and pieces of them, as in vtkIntervalVolume.
 * The scalar: SetInputArrayToProcess(0, ...), by default the active point scalars, one component.
 *
 * Output: VTK_TRIANGLE cells in a vtkUnstructuredGrid. A triangle's normal points to the
 * side of lower values.
 * - every point array, interpolated along the grid edge; integers come out as float (8 and 16 bits)
 *   or double; the scalar is the active one;
 * - every cell array, copied from the cell a triangle comes from;
 * - cell array `ContourId` (int): the index of the value.
 *
 * A composite input gives a composite output of the same structure. The same input gives the same
 * bytes whatever the number of threads.
 *
 * Errors (vtkErrorMacro, empty output) and warnings for each dataset: as in vtkIntervalVolume.
 * Warning (vtkWarningMacro, once for a composite input): an empty output and why, see
 * WarnOnEmptyOutput.
 *
 * The cells' ids are stored in 32 bits where they fit (vtkCellArray::IsStorage64Bit tells).
 *
 * When to use which: vtkFlyingEdges3D is the faster one on image data when only the surface is
 * wanted. On linear cells vtkContour3DLinearGrid is the slower one when triangles share points;
 * where they need not, MergePoints off is the way here too. This filter gives the surfaces that
 * bound the intervals of vtkIntervalVolume, carries all arrays, and takes every grid.
 *
 * @sa vtkIntervalVolume vtkIsotable
 */
class INTERLUMEINTERVALS_EXPORT vtkIsotableContour : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkIsotableContour* New();
  vtkTypeMacro(vtkIsotableContour, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The values, in the units of the scalar. Default none. Valid: finite, at most 20000 values.
   * SetValue adds values where there are fewer; GetValue is 0 where there is none.
   */
  void SetNumberOfContours(int number);
  int GetNumberOfContours() const { return static_cast<int>(this->Values.size()); }
  void SetValue(int i, double value);
  double GetValue(int i) const;
  ///@}

  ///@{
  /**
   * The precision of the output points: vtkAlgorithm::DEFAULT_PRECISION (that of the input's
   * points; float for image data), SINGLE_PRECISION or DOUBLE_PRECISION. Default DEFAULT_PRECISION.
   */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DEFAULT_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

  ///@{
  /**
   * Whether triangles share points. Where it is off, each has three points of its own, 3 t to
   * 3 t + 2 those of triangle t: the same triangles in the same order, with three to six times the
   * points. That is the faster way on unstructured grids, for pictures or for what takes triangles
   * one by one; elsewhere it takes more time than sharing. Default on.
   */
  vtkSetMacro(MergePoints, bool);
  vtkGetMacro(MergePoints, bool);
  vtkBooleanMacro(MergePoints, bool);
  ///@}

  ///@{
  /**
   * Whether an index of value ranges is kept between executions, so that changed values visit only
   * the cells near them. It is built when the values change for the first time over the same input.
   * Default on.
   */
  vtkSetMacro(UseValueIndex, bool);
  vtkGetMacro(UseValueIndex, bool);
  vtkBooleanMacro(UseValueIndex, bool);
  ///@}

  ///@{
  /**
   * Whether an execution that gives nothing warns, and says what is wrong and what the data have,
   * as in vtkIntervalVolume. Default on.
   */
  vtkSetMacro(WarnOnEmptyOutput, bool);
  vtkGetMacro(WarnOnEmptyOutput, bool);
  vtkBooleanMacro(WarnOnEmptyOutput, bool);
  ///@}

  ///@{
  /**
   * Whether the processes of the global controller tell each other at the end of an execution how
   * many cells gave output, as in vtkIntervalVolume. Default off.
   */
  vtkSetMacro(ReportBalance, bool);
  vtkGetMacro(ReportBalance, bool);
  vtkBooleanMacro(ReportBalance, bool);
  ///@}

  /**
   * Returns the report of the last execution:
   * - Cells, CellsWithOutput: cells of the input, and those of them that give a simplex
   * - BlankedCells: cells skipped because they or a point are blanked, hidden or a ghost
   * - NonFiniteCells: cells skipped because a value or a coordinate is NaN or infinite
   * - LowerDimensionalCells, UnsupportedCells: cells skipped because of their type
   * - LinearizedCells: quadratic and higher cells treated as linear
   * - ConcavePolyhedra: polyhedra whose parts overlap
   * - FoldedCells: cells with output that cross themselves
   * - LevelFaces: faces between two levels of an AMR input where the surface has gaps
   */
  vtkInterlumeReport* GetReport() { return this->Report; }

protected:
  vtkIsotableContour();
  ~vtkIsotableContour() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  /// Creates an output that is an unstructured grid or a composite dataset, as the input is.
  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkIsotableContour(const vtkIsotableContour&) = delete;
  void operator=(const vtkIsotableContour&) = delete;

  /// Returns an error if a value is invalid.
  interlume::Error CheckValues() const;
  /// Extracts from one dataset.
  void ExtractFrom(vtkDataSet* input, interlume::ExtractionRun& run, vtkUnstructuredGrid* output);

  std::vector<double> Values;
  int OutputPointsPrecision = DEFAULT_PRECISION;
  bool MergePoints = true;
  bool UseValueIndex = true;
  bool WarnOnEmptyOutput = true;
  bool ReportBalance = false;
  vtkNew<vtkInterlumeReport> Report;
  vtkSmartPointer<interlume::ExtractionIndex> Index;
};

#endif

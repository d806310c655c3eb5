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
 * @brief   extract isosurfaces of any dataset with convex-hull case tables
 *
 * Extracts the isosurfaces f = v of a scalar array, cell by cell, with isotables (P.
 * Bhaniramka, R. Wenger, R. Crawfis, "Isosurface construction in any dimension using convex hulls",
 * IEEE TVCG 10(2), 2004). For the method, see Documentation/methods/isotables.md; for timings, see
 * Documentation/measurements.md.
 *
 * Triangles of adjacent cells conform, even if the cells have different types, so the surface has
 * no cracks. A vertex is positive if f >= v. A face between two cells on which f equals v
 * everywhere, with lower values on both sides, has no triangles. On the boundary of the domain such
 * a face has triangles.
 *
 * Input: datasets, composite datasets and pieces as in vtkIntervalVolume. For the selection of the
 * scalar, and for cell arrays, see vtkIntervalAlgorithm.
 *
 * Output: VTK_TRIANGLE cells in a vtkUnstructuredGrid, whose normals point toward lower values. A
 * composite input produces a composite output of the same structure. Arrays:
 * - every point array, interpolated linearly along grid edges. Integers become float (8 and 16
 *   bits) or double. The processed array is the active scalars.
 * - every cell array, copied from the input cell
 * - cell array `ContourId` (int): the index of the isovalue
 *
 * The result does not depend on the number of threads.
 *
 * Errors and per-dataset warnings are the same as in vtkIntervalVolume. An empty output causes a
 * warning, see WarnOnEmptyOutput.
 *
 * Alternatives: for image data, vtkFlyingEdges3D is faster. vtkContour3DLinearGrid handles linear
 * cells. This filter accepts all grids, interpolates all arrays, and produces the exact boundary
 * surfaces of the intervals of vtkIntervalVolume.
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
   * Set/get the isovalues, in the units of the scalar. Default: none. Valid: at most 20000 finite
   * values. SetValue extends the list if needed. GetValue returns 0 if \a i is out of range.
   */
  void SetNumberOfContours(int number);
  int GetNumberOfContours() const { return static_cast<int>(this->Values.size()); }
  void SetValue(int i, double value);
  double GetValue(int i) const;
  ///@}

  ///@{
  /**
   * Set/get the precision of the output points: vtkAlgorithm::DEFAULT_PRECISION (the precision of
   * the input's points; float for image data), SINGLE_PRECISION or DOUBLE_PRECISION. Default
   * DEFAULT_PRECISION.
   */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DEFAULT_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

  ///@{
  /**
   * If true, triangles share points. If false, triangle t has the points 3 * t to 3 * t + 2.
   * Turning this off keeps the triangles and their order, but produces three to six times as many
   * points. It is faster on unstructured grids, for rendering or for consumers that process
   * triangles one by one. On other grids it is slower. Default on.
   */
  vtkSetMacro(MergePoints, bool);
  vtkGetMacro(MergePoints, bool);
  vtkBooleanMacro(MergePoints, bool);
  ///@}

  ///@{
  /**
   * If true, keep an index of value ranges between executions, so that after the isovalues change,
   * only cells with scalars near them are visited. The index is built when the isovalues change for
   * the first time while the input stays the same. Default on.
   */
  vtkSetMacro(UseValueIndex, bool);
  vtkGetMacro(UseValueIndex, bool);
  vtkBooleanMacro(UseValueIndex, bool);
  ///@}

  ///@{
  /**
   * Set/get the number of cells up to which a preview is exact, as in vtkIntervalVolume. Default 0:
   * no preview.
   */
  vtkSetClampMacro(PreviewCellLimit, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(PreviewCellLimit, vtkIdType);
  ///@}

  ///@{
  /**
   * If true, an execution with an empty output warns and reports the reason, as in
   * vtkIntervalVolume. Default on.
   */
  vtkSetMacro(WarnOnEmptyOutput, bool);
  vtkGetMacro(WarnOnEmptyOutput, bool);
  vtkBooleanMacro(WarnOnEmptyOutput, bool);
  ///@}

  ///@{
  /**
   * If true, each process of the global controller tells the others, at the end of an execution,
   * how many of its cells have output, as in vtkIntervalVolume. Default off.
   */
  vtkSetMacro(ReportBalance, bool);
  vtkGetMacro(ReportBalance, bool);
  vtkBooleanMacro(ReportBalance, bool);
  ///@}

  /**
   * Return the report of the last execution:
   * - Cells, CellsWithOutput: number of input cells, and of cells with output
   * - BlankedCells: cells skipped because the cell or one of its points is blanked, hidden or a
   *   ghost
   * - NonFiniteCells: cells skipped because a value or a coordinate is NaN or infinite
   * - LowerDimensionalCells, UnsupportedCells: cells skipped because of their type
   * - LinearizedCells: quadratic and higher-order cells treated as linear
   * - ConcavePolyhedra: polyhedra whose tetrahedra overlap
   * - FoldedCells: self-intersecting cells with output
   * - LevelFaces: faces between two levels of an AMR input where the surface has gaps
   * - ConvertedCellArrays: name of the scalar if it is a cell array, averaged at the points
   */
  vtkInterlumeReport* GetReport() { return this->Report; }

protected:
  vtkIsotableContour();
  ~vtkIsotableContour() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  /// Creates an unstructured grid for a dataset, or a composite dataset for a composite input.
  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkIsotableContour(const vtkIsotableContour&) = delete;
  void operator=(const vtkIsotableContour&) = delete;

  /// Returns an error if an isovalue is invalid.
  interlume::Error CheckValues() const;
  /// Extracts the isosurfaces from one dataset.
  void ExtractFrom(vtkDataSet* input, interlume::ExtractionRun& run, vtkUnstructuredGrid* output);

  std::vector<double> Values;
  int OutputPointsPrecision = DEFAULT_PRECISION;
  bool MergePoints = true;
  bool UseValueIndex = true;
  vtkIdType PreviewCellLimit = 0;
  bool WarnOnEmptyOutput = true;
  bool ReportBalance = false;
  vtkNew<vtkInterlumeReport> Report;
  vtkSmartPointer<interlume::ExtractionIndex> Index;
};

#endif

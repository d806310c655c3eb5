// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_Extraction_h
#define interlume_Extraction_h

#include "Pass/ExtractionContext.h"
#include "Pass/ExtractionIndex.h"

#include <array>
#include <vector>

class vtkUnstructuredGrid;

namespace interlume
{

struct InteriorCellPass;
class SizeWarning;

/**
 * @class   Extraction
 * @brief   one pass of contouring or interval extraction over one dataset
 *
 * Selects the implementation for the type of grid, and adds arrays to the extracted mesh.
 */
class Extraction
{
public:
  vtkAlgorithm* Owner = nullptr;
  const ExtractionValues* Values = nullptr;
  /// Warns about a large output; null in further passes.
  SizeWarning* Warning = nullptr;
  /// Index of value ranges; null if not used.
  ExtractionIndex* Index = nullptr;
  /// Name of the cell array of item indices; null if not written.
  const char* IdName = nullptr;
  int OutputPointsPrecision = vtkAlgorithm::DEFAULT_PRECISION;
  /// Dimension of the cells that are extracted, 2 or 3. Other cells are skipped.
  int Dimension = 3;
  /// If true, two extractions process the cells of two and three dimensions. Only the latter counts
  /// the cells of the input and the skipped cells of fewer dimensions.
  bool IsMixed = false;
  bool GenerateBoundaries = false;
  /// In a pass that applies a criterion, the BoundarySide of the triangles at the lower and upper
  /// ends of items.
  std::array<int, 2> Sides = { { 0, 1 } };
  /// Cells in which the scalars equal one of these values at all points are skipped.
  std::vector<double> SkippedConstants;
  /// If true, contour triangles share points.
  bool SharePoints = true;
  /// If true, the outputs contain arrays with the origin of each point and cell.
  bool GenerateOriginArrays = false;
  /// If true, tetrahedra keep their stored orientation. Set in the passes that apply criteria.
  bool KeepOrientation = false;
  /// State of interior cells, handed from pass to pass; null if interior cells are cut too.
  InteriorCellPass* InteriorPass = nullptr;
  /**
   * In a pass that applies a criterion, the boundary of the input, which is the boundary output of
   * the previous pass. Each triangle is cut like the tetrahedron that it is a face of, and added to
   * the boundary of this pass. Null in other passes, or if no boundary is requested.
   */
  vtkUnstructuredGrid* InputBoundary = nullptr;

  /// Runs the pass. \a boundary may be null. Returns false, with empty outputs, if the user
  /// aborted.
  bool Execute(vtkDataSet* input, vtkDataArray* scalars, vtkUnstructuredGrid* output,
    vtkUnstructuredGrid* boundary, ExtractionReport& report);

private:
  /// Replaces the input and the scalars of \a context by a grid of cells with isotables, if needed.
  /// Returns this grid, which is in the index or in \a own, or null.
  ExtractionIndex::LinearGrid* Linearize(
    ExtractionContext& context, ExtractionIndex::LinearGrid& own) const;
  void CheckSize(const ExtractionContext& context, vtkIdType points, vtkIdType simplices,
    vtkIdType interiorCells) const;
  bool ExtractMesh(ExtractionContext& context, ExtractionMesh& mesh, PointArrays& arrays);
  /// In a pass that applies a criterion, replaces the items of cells and boundary triangles by the
  /// intervals of the input's cells, and sets the sides of the triangles.
  void SetIntervals(vtkDataSet* input, ExtractionMesh& mesh) const;
  void FillOutput(const ExtractionContext& context, ExtractionMesh& mesh, PointArrays& arrays,
    vtkDataSet* original, vtkUnstructuredGrid* output) const;
  void FillBoundary(const ExtractionContext& context, const ExtractionMesh& mesh,
    vtkDataSet* original, vtkUnstructuredGrid* output, vtkUnstructuredGrid* boundary) const;
};

}

#endif

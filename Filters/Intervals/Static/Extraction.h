// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_Extraction_h
#define interlume_Extraction_h

#include "Pass/ExtractionContext.h"

class vtkUnstructuredGrid;

namespace interlume
{

struct WholePass;

/**
 * @class   Extraction
 * @brief   one pass of contouring or interval extraction over one dataset
 *
 * It chooses the way for the kind of grid, then gives the mesh its arrays.
 */
class Extraction
{
public:
  vtkAlgorithm* Owner = nullptr;
  const ExtractionValues* Values = nullptr;
  /// The index of value ranges; null for none.
  ExtractionIndex* Index = nullptr;
  /// The name of the cell array of item indices; null for none.
  const char* IdName = nullptr;
  int OutputPointsPrecision = vtkAlgorithm::DEFAULT_PRECISION;
  bool GenerateBoundaries = false;
  /// Whether triangles of contours have the points that they share but once.
  bool SharePoints = true;
  /// Whether the outputs tell what each of their points and cells was made of.
  bool KeepOrigins = false;
  /// Whether the input's tetrahedra are oriented as they are stored, for a further criterion.
  bool KeepOrientation = false;
  /// What passes tell each other of cells that are passed on whole; null where none are.
  WholePass* Whole = nullptr;
  /**
   * The boundary of the input, as port 1 of the pass before, for a further criterion. Its triangles
   * are cut like the tetrahedra they belong to. Null for none.
   */
  vtkUnstructuredGrid* InputBoundary = nullptr;

  /// Runs the pass. \a boundary may be null. Returns false when the user aborted; then the outputs
  /// are empty.
  bool Execute(vtkDataSet* input, vtkDataArray* scalars, vtkUnstructuredGrid* output,
    vtkUnstructuredGrid* boundary, ExtractionReport& report);

private:
  bool ExtractMesh(ExtractionContext& context, ExtractionMesh& mesh, PointArrays& arrays);
  void FillOutput(const ExtractionContext& context, ExtractionMesh& mesh, PointArrays& arrays,
    vtkDataSet* original, vtkUnstructuredGrid* output) const;
  void FillBoundary(const ExtractionMesh& mesh, vtkDataSet* original, vtkUnstructuredGrid* output,
    vtkUnstructuredGrid* boundary) const;
};

}

#endif

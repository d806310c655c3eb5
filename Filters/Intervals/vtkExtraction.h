#ifndef vtkExtraction_h
#define vtkExtraction_h

#include "vtkExtractionContext.h"

class vtkUnstructuredGrid;

/**
 * @class   vtkExtraction
 * @brief   one pass of contouring or interval extraction over one dataset
 *
 * Chooses the way for the kind of grid, then gives the mesh its arrays.
 */
class vtkExtraction
{
public:
  vtkAlgorithm* Owner = nullptr;
  const vtkExtractionValues* Values = nullptr;
  /// Null: no index.
  vtkExtractionIndex* Index = nullptr;
  /// Name of the cell array of item indices; null: none.
  const char* IdName = nullptr;
  int OutputPointsPrecision = vtkAlgorithm::DEFAULT_PRECISION;
  bool GenerateBoundaries = false;
  /// Whether the outputs say what each of their points and cells was made of.
  bool KeepOrigins = false;
  /// For a further criterion: whether the input's tetrahedra are oriented as they are stored.
  bool KeepOrientation = false;
  /**
   * For a further criterion: the boundary of the input, as port 1 of the pass before. Its triangles
   * are cut like the tetrahedra they belong to. Null: none.
   */
  vtkUnstructuredGrid* InputBoundary = nullptr;

  /// \a boundary may be null. Returns false when the user aborted; then the outputs are empty.
  bool Execute(vtkDataSet* input, vtkDataArray* scalars, vtkUnstructuredGrid* output,
    vtkUnstructuredGrid* boundary, vtkExtractionReport& report);

private:
  bool ExtractMesh(vtkExtractionContext& context, vtkExtractionMesh& mesh);
  void FillOutput(const vtkExtractionContext& context, vtkExtractionMesh& mesh,
    vtkDataSet* original, vtkUnstructuredGrid* output) const;
  void FillBoundary(const vtkExtractionMesh& mesh, vtkDataSet* original,
    vtkUnstructuredGrid* output, vtkUnstructuredGrid* boundary) const;
};

#endif

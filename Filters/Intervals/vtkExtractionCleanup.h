#ifndef vtkExtractionCleanup_h
#define vtkExtractionCleanup_h

#include "vtkExtractionContext.h"

class vtkUnstructuredGrid;

/**
 * @class   vtkExtractionCleanup
 * @brief   what has to be set right in a mesh in rare cases, and costs nothing in the others
 */
class vtkExtractionCleanup
{
public:
  /// Removes points that nothing uses; the others keep their order.
  static void RemoveUnusedPoints(vtkExtractionMesh& mesh);

  /**
   * Removes pairs of boundary triangles of one interval that have the same points and opposite
   * orientation: where the interval has no volume, both sides of nothing.
   */
  static void RemoveOppositeTriangles(vtkExtractionMesh& mesh);

  /**
   * Fills the boundary of \a mesh, which was cut out of the tetrahedra of \a input, with the faces
   * that lie in triangles of \a inputBoundary.
   */
  static void CutBoundary(
    vtkDataSet* input, vtkUnstructuredGrid* inputBoundary, vtkExtractionMesh& mesh);
};

#endif

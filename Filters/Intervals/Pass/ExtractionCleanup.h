// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ExtractionCleanup_h
#define interlume_ExtractionCleanup_h

#include "Output/TiedFaces.h"
#include "Pass/ExtractionContext.h"

class vtkUnstructuredGrid;

namespace interlume
{

struct WholePass;

/**
 * @class   ExtractionCleanup
 * @brief   repairs of a mesh that are needed in rare cases, and cost nothing in the others
 */
class ExtractionCleanup
{
public:
  /// Counts the faces of all tetrahedra, each in the group of its interval.
  static void CountFaces(const ExtractionMesh& mesh, TiedFaces<3>& faces);

  /// Removes the simplices and whole cells, by their places in the mesh, and the boundary triangles
  /// that are marked.
  static void RemoveMarked(
    ExtractionMesh& mesh, const std::vector<bool>& cells, const std::vector<bool>& triangles);

  /// Gives each triangle of a contour points of its own; the triangles keep their order.
  static void SplitPoints(ExtractionMesh& mesh);

  /// Removes points that nothing uses; the others keep their order. \a arrays has them where the
  /// mesh has no list, else it is null.
  static void RemoveUnusedPoints(ExtractionMesh& mesh, PointArrays* arrays);

  /**
   * Removes pairs of simplices of \a size points of one interval or contour that have the same
   * points and opposite orientation, of the two sides of a face where values equal a bound.
   */
  static void RemoveOppositeSimplices(ExtractionMesh& mesh, int size);

  /**
   * Settles the triangles of cells where values equal a bound. Pairs of one interval that have the
   * same points and opposite orientation go: they are both sides of nothing. Among the others those
   * stay that are faces of the interval's tetrahedra or whole cells, counted with their
   * orientation, and belong to the cell of that tetrahedron: where a side of a cell equals a bound,
   * the triangles there come from the cell beyond, and there may be no cell before it.
   */
  static void SettleTiedTriangles(const ExtractionContext& context, ExtractionMesh& mesh);

  /**
   * Fills the boundary of \a mesh, which was cut out of the tetrahedra of \a input, with the faces
   * that lie in triangles of \a inputBoundary. Those of whole cells, which \a whole tells, stay;
   * null where there are none.
   */
  static void CutBoundary(vtkDataSet* input, vtkUnstructuredGrid* inputBoundary,
    const WholePass* whole, ExtractionMesh& mesh);
};

}

#endif

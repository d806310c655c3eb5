// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ExtractionCleanup_h
#define interlume_ExtractionCleanup_h

#include "Output/TiedFaces.h"
#include "Pass/ExtractionContext.h"

class vtkUnstructuredGrid;

namespace interlume
{

struct InteriorCellPass;

/**
 * @class   ExtractionCleanup
 * @brief   corrections to an extracted mesh, needed for few inputs
 */
class ExtractionCleanup
{
public:
  /// Calls faces.Count() for each face of each tetrahedron, or each edge of each triangle, with the
  /// interval as the group.
  template <int Corners>
  static void CountFaces(const ExtractionMesh& mesh, TiedFaces<Corners>& faces);

  /// Removes the marked simplices, interior cells and boundary triangles. In \a cells, the marks of
  /// the interior cells follow those of the simplices.
  static void RemoveMarked(
    ExtractionMesh& mesh, const std::vector<bool>& cells, const std::vector<bool>& triangles);

  /// Gives each triangle of a contour its own points. The triangles keep their order.
  static void SplitPoints(ExtractionMesh& mesh);

  /// Removes unused points. The remaining points keep their order. \a arrays contains the points if
  /// the mesh has no list of points; otherwise it is null.
  static void RemoveUnusedPoints(ExtractionMesh& mesh, PointArrays* arrays);

  /**
   * Removes pairs of simplices with \a size points that belong to the same interval or contour and
   * have the same points but opposite orientation. They occur on the two sides of a face where
   * values equal a bound.
   */
  static void RemoveOppositeSimplices(ExtractionMesh& mesh, int size);

  /**
   * Corrects the boundary triangles, or lines, listed in TiedTriangles. If all values on a cell
   * face equal a bound, the cell outside the interval generates the triangles on that face, but
   * there may be no cell inside. Removes pairs of triangles of the same interval with the same
   * points and opposite orientation, since they enclose no volume. Keeps a remaining triangle only
   * if it is a face, with the same orientation, of a tetrahedron or interior cell of the interval,
   * and assigns it to the input cell of that tetrahedron or interior cell.
   */
  static void ResolveTiedTriangles(const ExtractionContext& context, ExtractionMesh& mesh);

  /**
   * Adds boundary triangles to \a mesh, whose tetrahedra were cut from those of the input: the
   * faces of tetrahedra that lie in a triangle of \a inputBoundary. For a mesh of triangles, adds
   * the boundary lines in the same way. Triangles of interior cells, which \a whole identifies, are
   * copied. \a whole is null if there are no interior cells. If values equal a bound, removes the
   * earlier triangles of the mesh that coincide with added ones.
   */
  static void CutBoundary(const ExtractionContext& context, vtkUnstructuredGrid* inputBoundary,
    const InteriorCellPass* whole, ExtractionMesh& mesh);

private:
  template <int Corners>
  static void ResolveTied(const ExtractionContext& context, ExtractionMesh& mesh);
};

}

#endif

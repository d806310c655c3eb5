// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TetrahedralMesherReport_h
#define interlume_TetrahedralMesherReport_h

#include "vtkType.h"

class vtkInterlumeReport;

namespace interlume
{

/**
 * @class   TetrahedralMesherReport
 * @brief   report of vtkTetrahedralMesher
 *
 * A value is 0 before the first execution and if it does not apply.
 */
struct TetrahedralMesherReport
{
  /// Number of decomposed three-dimensional cells.
  vtkIdType Cells = 0;
  /// Number of cells decomposed by TetGen, and of cells decomposed around a new interior point. All
  /// other cells needed no new point.
  vtkIdType CellsByTetGen = 0;
  vtkIdType CellsConed = 0;
  /// Number of skipped cells: ghost cells, hidden cells, and lower-dimensional cells next to
  /// three-dimensional cells.
  vtkIdType SkippedCells = 0;
  /// Number of cells skipped because their type is not supported.
  vtkIdType UnsupportedCells = 0;
  /// Number of triangles of the input surface.
  vtkIdType SurfaceTriangles = 0;
  /// Number of triangles of the input surface that were split because they touch other triangles
  /// (see SplitContacts).
  vtkIdType SplitTriangles = 0;
  /// Number of points of a surface or point set that were merged with a coincident point, and of
  /// points of cells that were merged with a coincident point of the same cell.
  vtkIdType MergedPoints = 0;
  /// Number of faces of cells, or polygons of a surface, that meet themselves: their edges cross or
  /// coincide, they have no area, or points of the cell were merged. FirstFoldedCell is the first
  /// cell with such a face (-1 if there is none).
  vtkIdType FoldedFaces = 0;
  vtkIdType FirstFoldedCell = -1;
  /// Number of output points that are not input points.
  vtkIdType AddedPoints = 0;
  /// Number of distinct values in the cell array RegionId.
  vtkIdType Regions = 0;
  /// Number of output tetrahedra, and of tetrahedra that exceed a bound.
  vtkIdType Tetrahedra = 0;
  vtkIdType TetrahedraAboveQualityBound = 0;
  vtkIdType TetrahedraAboveMaximumVolume = 0;
  /// Largest ratio of circumradius to shortest edge.
  double LargestRadiusEdgeRatio = 0.0;
  /// Smallest and largest volume of a tetrahedron, in cubic length units.
  double SmallestVolume = 0.0;
  double LargestVolume = 0.0;
  /// Number of problems sent to a worker process.
  vtkIdType TetGenCalls = 0;

  /// Counts a face of \a cell that meets itself.
  void AddFoldedFace(vtkIdType cell)
  {
    this->FirstFoldedCell = this->FoldedFaces == 0 ? cell : this->FirstFoldedCell;
    ++this->FoldedFaces;
  }

  void CopyTo(vtkInterlumeReport* report) const;
};

}

#endif

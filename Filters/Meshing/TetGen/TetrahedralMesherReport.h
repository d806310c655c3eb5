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
 * Every number is 0 before the first execution and if it does not apply.
 */
struct TetrahedralMesherReport
{
  /// The number of decomposed three-dimensional cells of the input.
  vtkIdType Cells = 0;
  /// The numbers of those cells that TetGen decomposed, and that were coned from a new point
  /// inside. The other cells needed no new point.
  vtkIdType CellsByTetGen = 0;
  vtkIdType CellsConed = 0;
  /// The number of skipped cells: of fewer dimensions next to three-dimensional cells, ghosts and
  /// hidden cells.
  vtkIdType SkippedCells = 0;
  /// The number of cells skipped because they are not linear.
  vtkIdType UnsupportedCells = 0;
  /// The number of triangles of the input surface.
  vtkIdType SurfaceTriangles = 0;
  /// The number of triangles of the input surface that were split because they touch others, see
  /// SplitContacts.
  vtkIdType SplitTriangles = 0;
  /// The number of points of a surface or point set merged with another point at the same
  /// position.
  vtkIdType MergedPoints = 0;
  /// The number of points of the output that the input does not have.
  vtkIdType AddedPoints = 0;
  /// The number of values of the cell array RegionId.
  vtkIdType Regions = 0;
  /// The numbers of tetrahedra of the output, and of those above a bound that was set.
  vtkIdType Tetrahedra = 0;
  vtkIdType TetrahedraAboveQualityBound = 0;
  vtkIdType TetrahedraAboveMaximumVolume = 0;
  /// The largest ratio of circumscribed radius to shortest edge of a tetrahedron.
  double LargestRadiusEdgeRatio = 0.0;
  /// The smallest and largest volume of a tetrahedron, in cubes of the unit of length.
  double SmallestVolume = 0.0;
  double LargestVolume = 0.0;
  /// The number of problems sent to a worker process.
  vtkIdType TetGenCalls = 0;

  void CopyTo(vtkInterlumeReport* report) const;
};

}

#endif

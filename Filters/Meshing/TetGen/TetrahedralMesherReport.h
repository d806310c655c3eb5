// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTetrahedralMesherReport_h
#define vtkTetrahedralMesherReport_h

#include "InterlumeMeshingModule.h" // for the export macro
#include "vtkIndent.h"
#include "vtkType.h"

/**
 * @class   vtkTetrahedralMesherReport
 * @brief   what the last execution of vtkTetrahedralMesher did
 *
 * This is a plain value object. Every number is 0 before the first execution and where it does not
 * apply.
 *
 * @sa vtkTetrahedralMesher
 */
struct INTERLUMEMESHING_EXPORT vtkTetrahedralMesherReport
{
  /// The numbers of three-dimensional cells of the input that were decomposed, of those among them
  /// that TetGen decomposed, and of those that were coned from a new point inside. The others
  /// needed no new point.
  vtkIdType Cells = 0;
  vtkIdType CellsByTetGen = 0;
  vtkIdType CellsConed = 0;
  /// The number of cells left out: of fewer dimensions beside three-dimensional ones, ghosts and
  /// hidden cells.
  vtkIdType CellsLeftOut = 0;
  /// The number of cells left out because they are not linear.
  vtkIdType UnsupportedCells = 0;
  /// The number of triangles of the input surface.
  vtkIdType SurfaceTriangles = 0;
  /// The number of triangles of the input surface that were split because they touch others, see
  /// SplitContacts.
  vtkIdType SplitTriangles = 0;
  /// The number of points of a surface or point set left out because another one is in the same
  /// place.
  vtkIdType MergedPoints = 0;
  /// The number of points of the output that the input does not have.
  vtkIdType AddedPoints = 0;
  /// The number of values of the cell array RegionId.
  vtkIdType Regions = 0;
  /// The numbers of tetrahedra of the output, and of those among them beyond a bound that was set.
  vtkIdType Tetrahedra = 0;
  vtkIdType TetrahedraAboveQualityBound = 0;
  vtkIdType TetrahedraAboveMaximumVolume = 0;
  /// The largest ratio of circumscribed radius to shortest edge of a tetrahedron.
  double LargestRadiusEdgeRatio = 0.0;
  /// The smallest and largest volume of a tetrahedron, in cubes of the unit of length.
  double SmallestVolume = 0.0;
  double LargestVolume = 0.0;
  /// The number of times that a worker process was asked.
  vtkIdType TetGenCalls = 0;

  void Print(ostream& os, vtkIndent indent) const;
};

#endif

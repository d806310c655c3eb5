// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CellRefinement_h
#define interlume_CellRefinement_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkDataSet;
class vtkUnstructuredGrid;

namespace interlume
{

/**
 * @class   CellRefinement
 * @brief   refines cells of an implicit flow field that cannot be interpolated
 *
 * A cell is mixed if its corners differ in status or id, or if time is discontinuous within it
 * (ImplicitFlowArrays::IsAcrossSurface). Cells that a flow volume cuts at a surface
 * (FarSideSamples) are excluded. All edges of mixed cells are marked. Tetrahedra with marked edges
 * are cut by MarkedBisection. Any other cell with a marked edge gets a point at its center, and
 * each of its quadrilaterals with a marked edge gets a point at the face center. Such a
 * quadrilateral becomes four triangles and, with the cell's center, four tetrahedra. Other faces
 * form a pyramid or a tetrahedron with the center. The tetrahedra are then cut at their marked
 * edges. Neighbors that conformed before therefore still conform.
 *
 * New points on edges come first, then points on quadrilaterals, both in the order of their corner
 * ids, then points in cells. Point arrays are interpolated; the ghost type of a new point has the
 * bits common to all corners of its edge, face or cell. New cells inherit the cell arrays of the
 * cell that they subdivide.
 *
 * Lower-dimensional cells, quadratic cells, polyhedra, prisms, and hidden or blanked cells remain
 * unchanged, and their neighbors need not conform. Duplicate cells, whose originals are in another
 * piece, are refined like all others.
 */
class CellRefinement
{
public:
  /// Creates a grid with the points, cells and arrays of a dataset. Structured data become voxels
  /// or hexahedra.
  static vtkSmartPointer<vtkUnstructuredGrid> MakeGrid(vtkDataSet* data);

  struct Result
  {
    /// The refined grid, or the input grid if no cell is mixed; null if an array is missing.
    vtkSmartPointer<vtkUnstructuredGrid> Grid;
    /// Number of mixed cells of the input grid, which were refined.
    vtkIdType MixedCells = 0;
  };
  /// Refines by one level. \a grid needs the arrays of vtkFlowStatus.
  static Result Refine(vtkUnstructuredGrid* grid);
};

}

#endif

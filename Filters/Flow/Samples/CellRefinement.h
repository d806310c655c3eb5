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
 * @brief   cells of an implicit flow field cut where their corners cannot be interpolated between
 *
 * Cells are mixed whose corners differ in status or id, or lie across their surface
 * (ImplicitFlowArrays::IsAcrossSurface), but for those that a surface alone is the reason for
 * (BeyondSamples): a flow volume cuts these cells there. All edges of mixed cells are marked.
 * Tetrahedra with marked edges are cut by MarkedBisection. Any other cell with a marked edge gets a
 * point in the middle of its corners, each of its quadrilaterals with a marked edge one in the
 * middle of its own. Such a quadrilateral becomes four triangles and, with the cell's point, four
 * tetrahedra; other faces make a pyramid or a tetrahedron. The tetrahedra are cut by their marked
 * edges. So cells fit face to face where they did before.
 *
 * New points are in the order of marked edges, of quadrilaterals by their ids, and of cells. Point
 * arrays are interpolated to them, ghost types are what all corners share; new cells have the cell
 * arrays of the one they are parts of.
 *
 * Cells of fewer dimensions, quadratic ones, polyhedra and prisms stay as they are, and so do
 * hidden and blanked cells: what is beside them need not fit. Duplicates of other pieces are cut as
 * all others are.
 */
class CellRefinement
{
public:
  /// Makes a grid with the points, cells and arrays of a dataset: voxels or hexahedra for a grid of
  /// rows.
  static vtkSmartPointer<vtkUnstructuredGrid> MakeGrid(vtkDataSet* data);

  struct Result
  {
    /// The refined grid, or the same grid where nothing was to be refined; null where an array is
    /// missing.
    vtkSmartPointer<vtkUnstructuredGrid> Grid;
    /// The number of cells of the grid before that are mixed, and were refined.
    vtkIdType MixedCells = 0;
  };
  /// Refines by one level. \a grid has the arrays of vtkFlowStatus.
  static Result Refine(vtkUnstructuredGrid* grid);
};

}

#endif

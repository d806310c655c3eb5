// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_GridSampling_h
#define interlume_GridSampling_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

class vtkDataSet;

namespace interlume
{

/**
 * @class   GridSampling
 * @brief   coarse copies of structured grids, for previews
 *
 * A coarse copy has every n-th point along each axis, and the last point. It spans the cells that
 * are not ghost cells, so the copies of several pieces neither overlap nor leave gaps. A coarse
 * cell has the arrays and the blanking of its first cell.
 */
class GridSampling
{
public:
  /// Returns the number of cells of a coarse copy, or of \a input if it has no coarse copy. All
  /// cells are counted, even ghost cells.
  static vtkIdType CountCells(vtkDataSet* input, int stride);

  /// Returns the lowest stride n for which the coarse copies of all structured grids together have
  /// at most \a limit cells. Elements of \a leaves may be null.
  static int ChooseStride(const std::vector<vtkDataSet*>& leaves, vtkIdType limit);

  /// Returns a coarse copy of image data, a rectilinear grid or a structured grid. Returns null for
  /// other datasets, and for grids without three-dimensional cells.
  static vtkSmartPointer<vtkDataSet> Sample(vtkDataSet* input, int stride);
};

}

#endif

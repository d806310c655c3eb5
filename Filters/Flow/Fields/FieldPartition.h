// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FieldPartition_h
#define interlume_FieldPartition_h

#include "vtkType.h"

class vtkDataSet;

namespace interlume
{

/**
 * @class   FieldPartition
 * @brief   partition of a grid that belongs to one process
 *
 * Each cell of the grid is owned by one process. In structured (i, j, k) grids, partitions are
 * point extents of the full grid, and Held is the extent of the available data: the owned cells and
 * all neighbors, including neighbors at corners. In unstructured grids, only owned cells are
 * available.
 */
struct FieldPartition
{
  /// Full grid without arrays.
  vtkDataSet* FullGrid = nullptr;
  int WholeExtent[6] = { 0, -1, 0, -1, 0, -1 };
  int Own[6] = { 0, -1, 0, -1, 0, -1 };
  int Held[6] = { 0, -1, 0, -1, 0, -1 };
  /// Range of the global ids of the owned cells of an unstructured grid. EndCell is not included.
  vtkIdType FirstCell = 0;
  vtkIdType EndCell = 0;

  /// Returns whether a point extent has three-dimensional cells.
  static bool HasCells(const int extent[6])
  {
    return extent[0] < extent[1] && extent[2] < extent[3] && extent[4] < extent[5];
  }
};

}

#endif

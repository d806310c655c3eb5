// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_GridCellRange_h
#define interlume_GridCellRange_h

#include "vtkType.h"

#include <array>
#include <functional>

namespace interlume
{

struct Blanking;

/**
 * @class   GridCellRange
 * @brief   a box of cells of a structured grid
 *
 * In a piece of image data that is surrounded by ghost cells, the cells to extract form a box.
 * Using the box avoids a ghost test per cell.
 */
struct GridCellRange
{
  /// Half-open range [First, Last) of cells along each axis.
  std::array<vtkIdType, 3> First;
  std::array<vtkIdType, 3> Last;

  /// Creates the box of all cells of a grid with the given number of points per axis.
  explicit GridCellRange(const int dimensions[3]);

  vtkIdType GetNumberOfCells() const;

  /**
   * Shrinks the box of all cells to the cells that are not blanked. Returns false if these cells do
   * not form a box, if all cells are blanked, or if the grid has no cell ghost array or has a point
   * ghost array.
   */
  bool Shrink(const Blanking& blanking, const int dimensions[3]);

  /**
   * Calls \a work(first, last) for ranges of points of the grid until it returns true. The ranges
   * together contain all points of the cells outside the box. Returns whether a call returned true.
   */
  bool AnyOutside(const int dimensions[3],
    const std::function<bool(vtkIdType first, vtkIdType last)>& work) const;
};

}

#endif

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
  /// The cells along each axis are [First, Last).
  std::array<vtkIdType, 3> First;
  std::array<vtkIdType, 3> Last;

  /// Creates the box of all cells of a grid with the given number of points per axis.
  explicit GridCellRange(const int dimensions[3]);

  vtkIdType GetNumberOfCells() const;

  /**
   * Shrinks the box of all cells to the included cells. Returns false if the ghost array excludes
   * all cells or if the included cells do not form a box.
   */
  bool Shrink(const Blanking& blanking, const int dimensions[3]);

  /**
   * Calls \a work(first, last) for ranges of points of the grid until it returns true. Together the
   * ranges contain all points of cells outside the box. Returns whether a call returned true.
   */
  bool AnyOutside(const int dimensions[3],
    const std::function<bool(vtkIdType first, vtkIdType last)>& work) const;
};

}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_GridWindow_h
#define interlume_GridWindow_h

#include "vtkType.h"

#include <array>
#include <functional>

namespace interlume
{

struct Blanking;

/**
 * @class   GridWindow
 * @brief   a box of cells of a grid of rows
 *
 * A piece of an image with a layer of other pieces' cells around it is one, so that nobody has to
 * ask each cell whether it counts.
 */
struct GridWindow
{
  /// Its cells along each axis are [First, Last).
  std::array<vtkIdType, 3> First;
  std::array<vtkIdType, 3> Last;

  /// The box of all cells of a grid with so many points along each axis.
  explicit GridWindow(const int dimensions[3]);

  vtkIdType GetNumberOfCells() const;

  /**
   * Shrinks the box of all cells to those that count, if all of it count and none beyond it, by the
   * ghost array of cells. Returns whether it is so, and there is one.
   */
  bool Shrink(const Blanking& blanking, const int dimensions[3]);

  /**
   * Calls \a work(first, last) for runs of points of the grid, which together are all that cells
   * beyond the box have, until it returns true. Returns whether it did.
   */
  bool AnyBeyond(const int dimensions[3],
    const std::function<bool(vtkIdType first, vtkIdType last)>& work) const;
};

}

#endif

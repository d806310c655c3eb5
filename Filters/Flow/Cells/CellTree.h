// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CellTree_h
#define interlume_CellTree_h

#include "vtkType.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace interlume
{

/**
 * @class   CellTree
 * @brief   finds the cells whose bounding boxes contain a point
 *
 * The tree is a bounding volume hierarchy over the cells, which are sorted by the Morton codes of
 * their box centers. Cells with equal codes are sorted by id. Leaves have up to eight cells, inner
 * nodes up to four children. The tree is built in parallel, does not depend on the number of
 * threads, and can be read by any number of threads.
 */
class CellTree
{
public:
  /// Callback that computes the bounds (xmin, xmax, ymin, ...) of a cell. It returns false to
  /// exclude the cell.
  using CellBox = std::function<bool(vtkIdType cell, double box[6])>;

  /// Callback that extends the bounds of the cells to the bounds in all processes, so that Morton
  /// codes are comparable between processes.
  using Unite = std::function<void(double bounds[6])>;

  void Build(vtkIdType numberOfCells, const CellBox& getBox, const Unite& unite = {});

  /// Returns the Morton code of the center of a cell's box, by which the tree sorts its cells.
  std::uint64_t GetOrder(const double box[6]) const;
  /// Returns slightly enlarged bounds of the cells in this tree, or null if there are none.
  const double* GetBounds() const
  {
    return this->Levels.empty() ? nullptr : this->Levels.back().front().Bounds;
  }

  /**
   * Calls visit(cell) for a superset of the cells that contain \a x, namely all cells of the leaves
   * whose boxes contain \a x, in a fixed order, until a call returns true. Returns whether a
   * call returned true. The boxes are inflated by more than in InterpolatedCell::IsInBox. Therefore
   * the assignment of cells to leaves does not affect the result.
   */
  template <typename Visitor>
  bool Visit(const double x[3], Visitor&& visit) const;

private:
  static constexpr int LeafSize = 8;
  static constexpr int Arity = 4;
  // Height of a tree with 2^63 cells.
  static constexpr int MaximumHeight = 32;

  struct Box
  {
    double Bounds[6];

    void Clear();
    void Add(const double bounds[6]);
    void Inflate();
    bool Holds(const double x[3]) const
    {
      return x[0] >= this->Bounds[0] && x[0] <= this->Bounds[1] && x[1] >= this->Bounds[2] &&
        x[1] <= this->Bounds[3] && x[2] >= this->Bounds[4] && x[2] <= this->Bounds[5];
    }
  };

  // Bounds of all cells, including the cells of the trees in other processes.
  Box All;
  std::vector<vtkIdType> Cells;
  // Boxes of the nodes of each level, from the leaves to the root.
  std::vector<std::vector<Box>> Levels;
};

template <typename Visitor>
bool CellTree::Visit(const double x[3], Visitor&& visit) const
{
  if (this->Cells.empty())
  {
    return false;
  }
  struct Node
  {
    int Level;
    std::size_t Number;
  };
  Node stack[MaximumHeight * Arity];
  int height = 0;
  stack[height++] = { static_cast<int>(this->Levels.size()) - 1, 0 };
  while (height > 0)
  {
    const Node node = stack[--height];
    if (!this->Levels[node.Level][node.Number].Holds(x))
    {
      continue;
    }
    if (node.Level > 0)
    {
      const std::size_t first = node.Number * Arity;
      for (std::size_t child = std::min(first + Arity, this->Levels[node.Level - 1].size());
           child > first; --child)
      {
        stack[height++] = { node.Level - 1, child - 1 };
      }
      continue;
    }
    const std::size_t first = node.Number * LeafSize;
    const std::size_t last = std::min(first + LeafSize, this->Cells.size());
    for (std::size_t i = first; i < last; ++i)
    {
      if (visit(this->Cells[i]))
      {
        return true;
      }
    }
  }
  return false;
}

}

#endif

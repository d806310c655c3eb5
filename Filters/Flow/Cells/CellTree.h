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
 * @brief   which cells' boxes hold a point
 *
 * The tree is a bounding volume hierarchy over cells in Morton order of their boxes' centres:
 * leaves of eight cells, four children to a node. All threads build it, any number may read it, and
 * it is always the same. Cells whose boxes have the same place in that order come by their numbers.
 */
class CellTree
{
public:
  /// A function that gives lower and upper of x, y, z of a cell; false for a cell to leave out.
  using CellBox = std::function<bool(vtkIdType cell, double box[6])>;

  /// A function that unites bounds, lower and upper of x, y, z, with those of other trees whose
  /// cells are to be in the same order.
  using Unite = std::function<void(double bounds[6])>;

  void Build(vtkIdType numberOfCells, const CellBox& getBox, const Unite& unite = {});

  /// Returns the place of a box in the order, before the number of its cell.
  std::uint64_t GetOrder(const double box[6]) const;
  /// Returns bounds beyond which Visit finds no cell; null without cells.
  const double* GetBounds() const
  {
    return this->Levels.empty() ? nullptr : this->Levels.back().front().Bounds;
  }

  /**
   * Calls visit(cell) for the cells of leaves whose box holds \a x, a superset of the cells that
   * hold it, in an order of the tree's, until it returns true. Returns whether it did. Boxes are a
   * little larger than their cells, by more than those of InterpolatedCell::IsInBox: which cells
   * share a leaf decides nothing.
   */
  template <typename Visitor>
  bool Visit(const double x[3], Visitor&& visit) const;

private:
  static constexpr int LeafSize = 8;
  static constexpr int Arity = 4;
  // The height of a tree over all 2^63 cells.
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

  // The bounds of all cells, here and in trees of the same order.
  Box All;
  std::vector<vtkIdType> Cells;
  // The levels of boxes, the leaves first, the root last.
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

// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PieceOrder_h
#define interlume_PieceOrder_h

#include <array>
#include <vector>

namespace interlume
{

/**
 * @class   PieceOrder
 * @brief   the visibility order of bounding boxes, for any view
 *
 * Axis-aligned planes recursively separate the boxes into two groups until each group has one box
 * (a BSP tree; Fuchs, Kedem, Naylor 1980). Boxes on the camera's side of a plane may hide boxes on
 * the other side, but never the reverse, so the order is exact. Boxes that touch are separable, and
 * so are boxes that overlap by at most a millionth of the extent of their group.
 */
class PieceOrder
{
public:
  /// Bounds as in vtkDataSet::GetBounds(). A lower bound above the upper bound means an empty box.
  using Box = std::array<double, 6>;

  explicit PieceOrder(const std::vector<Box>& boxes);

  /// Returns true if axis-aligned planes can separate all boxes.
  bool IsPossible() const { return this->Possible; }

  /**
   * Returns the indices of all boxes, front to back. \a eye is the camera position in homogeneous
   * coordinates with w >= 0. In parallel projection it is the point at infinity where the view rays
   * originate.
   */
  std::vector<int> Compute(const std::array<double, 4>& eye) const;

private:
  /// An inner node has a plane that separates its two children. A leaf has boxes, at most one of
  /// which is not empty if IsPossible() is true.
  struct Node
  {
    int Axis = -1;
    double Plane = 0.0;
    int Lower = -1;
    int Upper = -1;
    std::vector<int> Boxes;
  };

  /// Appends a node and returns its index. Build() returns the index of the root of a new subtree.
  int Add(const Node& node);
  int Build(const std::vector<Box>& boxes, std::vector<int> members);
  void Append(int node, const std::array<double, 4>& eye, std::vector<int>& order) const;

  bool Possible = true;
  std::vector<Node> Nodes;
  int Root = -1;
  /// Index of the leaf with the empty boxes.
  int Last = -1;
};

}

#endif

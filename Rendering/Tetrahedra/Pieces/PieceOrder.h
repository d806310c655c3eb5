// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PieceOrder_h
#define interlume_PieceOrder_h

#include <array>
#include <vector>

namespace interlume
{

/**
 * @class   PieceOrder
 * @brief   the order of visibility of boxes around pieces, for any view
 *
 * Planes along the axes part all boxes into two groups, and these again until each box is alone
 * (a BSP tree, Fuchs, Kedem, Naylor 1980). What is on the eye's side of a plane hides what is on
 * the other side and never the other way round, so the order is exact for what the boxes hold.
 * Boxes that touch are apart; so are those that share a millionth of what their group is long.
 */
class PieceOrder
{
public:
  /// The ends of a box along each axis; a lower end above the upper one is a box without content.
  using Box = std::array<double, 6>;

  explicit PieceOrder(const std::vector<Box>& boxes);

  /// Returns whether planes part all boxes.
  bool IsPossible() const { return this->Possible; }

  /**
   * Returns the indices of all boxes, the nearest first. \a eye is the place of the eye in
   * homogeneous coordinates, for a parallel projection a point at infinity, where the rays come
   * from: w is 0 or more.
   */
  std::vector<int> Compute(const std::array<double, 4>& eye) const;

private:
  /// A plane that parts two nodes; a leaf has no plane but boxes, of which one at most has content.
  struct Node
  {
    int Axis = -1;
    double Plane = 0.0;
    int Lower = -1;
    int Upper = -1;
    std::vector<int> Boxes;
  };

  /// Returns the index of the node that it adds, as Build does of the topmost.
  int Add(const Node& node);
  int Build(const std::vector<Box>& boxes, std::vector<int> members);
  void Append(int node, const std::array<double, 4>& eye, std::vector<int>& order) const;

  bool Possible = true;
  std::vector<Node> Nodes;
  int Root = -1;
  /// The leaf of the boxes without content.
  int Last = -1;
};

}

#endif

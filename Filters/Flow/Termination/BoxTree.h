// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_BoxTree_h
#define interlume_BoxTree_h

#include <algorithm>
#include <array>
#include <vector>

namespace interlume
{

/**
 * @class   BoxTree
 * @brief   a hierarchy of bounding boxes, which finds the items nearest to a point
 *
 * It is a binary tree, cut at the median of the longest axis; the same for the same boxes. Queries
 * change nothing, so threads may make them at once.
 */
class BoxTree
{
public:
  struct Box
  {
    double Lower[3];
    double Upper[3];
  };

  /// Builds the tree in place of the one before. Items are known by their index in \a boxes.
  void Build(const std::vector<Box>& boxes);

  /**
   * Calls \a visit(item, squaredLimit) for the items whose box is nearer to \a x than the limit; it
   * may lower the limit, and usually does.
   */
  template <typename Visitor>
  void VisitNear(const double x[3], double squaredLimit, const Visitor& visit) const;

private:
  struct Node
  {
    Box Bounds;
    /// The items of a leaf; an inner node has none, and its children at First and First + 1.
    int First;
    int NumberOfItems;
  };
  /// Computes the bounds of a range of items, and makes a leaf or two children of it.
  void BuildNode(std::size_t node, int first, int last, const std::vector<Box>& boxes);

  static double GetSquaredDistance(const Box& box, const double x[3]);

  static constexpr int LeafSize = 4;
  /// The number of levels of a tree of as many items as an int counts.
  static constexpr int MaximumDepth = 32;
  std::vector<Node> Nodes;
  std::vector<int> Items;
};

inline double BoxTree::GetSquaredDistance(const Box& box, const double x[3])
{
  double sum = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double distance = std::max({ box.Lower[i] - x[i], x[i] - box.Upper[i], 0.0 });
    sum += distance * distance;
  }
  return sum;
}

template <typename Visitor>
void BoxTree::VisitNear(const double x[3], double squaredLimit, const Visitor& visit) const
{
  struct Entry
  {
    int Node;
    double SquaredDistance;
  };
  std::array<Entry, MaximumDepth + 2> stack;
  int size = 0;
  if (!this->Nodes.empty())
  {
    stack[size++] = { 0, GetSquaredDistance(this->Nodes[0].Bounds, x) };
  }
  while (size > 0)
  {
    const Entry entry = stack[--size];
    if (!(entry.SquaredDistance < squaredLimit))
    {
      continue;
    }
    const Node& node = this->Nodes[entry.Node];
    for (int i = 0; i < node.NumberOfItems; ++i)
    {
      visit(this->Items[node.First + i], squaredLimit);
    }
    if (node.NumberOfItems == 0)
    {
      Entry children[2];
      for (int i = 0; i < 2; ++i)
      {
        children[i] = { node.First + i, GetSquaredDistance(this->Nodes[node.First + i].Bounds, x) };
      }
      const int nearer = children[1].SquaredDistance < children[0].SquaredDistance ? 1 : 0;
      stack[size++] = children[1 - nearer];
      stack[size++] = children[nearer];
    }
  }
}

}

#endif

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
 * @brief   hierarchy of bounding boxes that finds the items nearest to a point
 *
 * It is a binary tree split at the median of the longest axis. The tree depends only on the boxes.
 * Queries are const and thread-safe.
 */
class BoxTree
{
public:
  struct Box
  {
    double Lower[3];
    double Upper[3];
  };

  /// Rebuilds the tree. Items are indices into \a boxes.
  void Build(const std::vector<Box>& boxes);

  /**
   * Calls \a visit(item, squaredLimit) for each item whose box is closer to \a x than the limit. \a
   * visit may reduce the limit.
   */
  template <typename Visitor>
  void VisitNear(const double x[3], double squaredLimit, const Visitor& visit) const;

private:
  struct Node
  {
    Box Bounds;
    /// Range of a leaf's items. In an inner node, NumberOfItems is 0, and nodes First and First + 1
    /// are the children.
    int First;
    int NumberOfItems;
  };
  /// Computes the bounds of a range of items, and creates a leaf or two children.
  void BuildNode(std::size_t node, int first, int last, const std::vector<Box>& boxes);

  static double GetSquaredDistance(const Box& box, const double x[3]);

  static constexpr int LeafSize = 4;
  /// Number of levels of the largest tree with int indices.
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
      const int closer = children[1].SquaredDistance < children[0].SquaredDistance ? 1 : 0;
      stack[size++] = children[1 - closer];
      stack[size++] = children[closer];
    }
  }
}

}

#endif

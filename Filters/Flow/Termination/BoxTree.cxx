// SPDX-License-Identifier: BSD-3-Clause
#include "Termination/BoxTree.h"

#include <numeric>
#include <tuple>

namespace interlume
{

void BoxTree::Build(const std::vector<Box>& boxes)
{
  this->Nodes.clear();
  this->Items.resize(boxes.size());
  std::iota(this->Items.begin(), this->Items.end(), 0);
  if (!boxes.empty())
  {
    this->Nodes.emplace_back();
    this->BuildNode(0, 0, static_cast<int>(boxes.size()), boxes);
  }
}

void BoxTree::BuildNode(std::size_t node, int first, int last, const std::vector<Box>& boxes)
{
  Box bounds = boxes[this->Items[first]];
  for (int i = first + 1; i < last; ++i)
  {
    const Box& box = boxes[this->Items[i]];
    for (int axis = 0; axis < 3; ++axis)
    {
      bounds.Lower[axis] = std::min(bounds.Lower[axis], box.Lower[axis]);
      bounds.Upper[axis] = std::max(bounds.Upper[axis], box.Upper[axis]);
    }
  }
  this->Nodes[node] = { bounds, first, last - first };
  if (last - first <= LeafSize)
  {
    return;
  }
  int longest = 0;
  for (int axis = 1; axis < 3; ++axis)
  {
    longest =
      bounds.Upper[axis] - bounds.Lower[axis] > bounds.Upper[longest] - bounds.Lower[longest]
      ? axis
      : longest;
  }
  const int median = first + (last - first) / 2;
  const auto key = [&boxes, longest](int item)
  { return std::make_tuple(boxes[item].Lower[longest] + boxes[item].Upper[longest], item); };
  std::nth_element(this->Items.begin() + first, this->Items.begin() + median,
    this->Items.begin() + last, [&key](int a, int b) { return key(a) < key(b); });
  const std::size_t child = this->Nodes.size();
  this->Nodes.resize(child + 2);
  this->Nodes[node].First = static_cast<int>(child);
  this->Nodes[node].NumberOfItems = 0;
  this->BuildNode(child, first, median, boxes);
  this->BuildNode(child + 1, median, last, boxes);
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Pieces/PieceOrder.h"

#include <algorithm>
#include <cstddef>

namespace interlume
{

namespace
{
/// Partition boundaries have single precision, so boxes may overlap by this fraction of the extent
/// of the group that is being divided.
constexpr double OVERLAP = 1e-6;

bool HasContent(const PieceOrder::Box& box)
{
  return box[0] <= box[1] && box[2] <= box[3] && box[4] <= box[5];
}
}

PieceOrder::PieceOrder(const std::vector<Box>& boxes)
{
  std::vector<int> full;
  std::vector<int> empty;
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    (HasContent(boxes[i]) ? full : empty).push_back(static_cast<int>(i));
  }
  this->Root = this->Build(boxes, full);
  // Empty boxes hide nothing, so their position in the order does not matter.
  Node last;
  last.Boxes = empty;
  this->Last = this->Add(last);
}

int PieceOrder::Add(const Node& node)
{
  this->Nodes.push_back(node);
  return static_cast<int>(this->Nodes.size()) - 1;
}

int PieceOrder::Build(const std::vector<Box>& boxes, std::vector<int> members)
{
  Node node;
  if (members.size() < 2)
  {
    node.Boxes = members;
    return this->Add(node);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto lower = [&](int box) { return boxes[static_cast<std::size_t>(box)][2 * axis]; };
    const auto upper = [&](int box) { return boxes[static_cast<std::size_t>(box)][2 * axis + 1]; };
    // Sort by centers, so that a flat box in the plane of another box's face is on the correct
    // side.
    std::sort(members.begin(), members.end(),
      [&](int a, int b)
      {
        const double centers[2] = { lower(a) + upper(a), lower(b) + upper(b) };
        return centers[0] != centers[1] ? centers[0] < centers[1] : a < b;
      });
    std::vector<double> next(members.size());
    double minimum = lower(members.back());
    for (std::size_t i = members.size(); i-- > 0;)
    {
      minimum = std::min(minimum, lower(members[i]));
      next[i] = minimum;
    }
    double maximum = upper(members[0]);
    for (const int member : members)
    {
      maximum = std::max(maximum, upper(member));
    }
    const double overlap = OVERLAP * (maximum - minimum);
    maximum = upper(members[0]);
    for (std::size_t i = 1; i < members.size(); ++i)
    {
      if (maximum - next[i] <= overlap)
      {
        const auto split = members.begin() + static_cast<std::ptrdiff_t>(i);
        node.Axis = axis;
        node.Plane = 0.5 * (maximum + next[i]);
        node.Lower = this->Build(boxes, { members.begin(), split });
        node.Upper = this->Build(boxes, { split, members.end() });
        return this->Add(node);
      }
      maximum = std::max(maximum, upper(members[i]));
    }
  }
  this->Possible = false;
  node.Boxes = members;
  return this->Add(node);
}

void PieceOrder::Append(int node, const std::array<double, 4>& eye, std::vector<int>& order) const
{
  const Node& n = this->Nodes[static_cast<std::size_t>(node)];
  if (n.Axis < 0)
  {
    order.insert(order.end(), n.Boxes.begin(), n.Boxes.end());
    return;
  }
  const bool isLowerNear = eye[static_cast<std::size_t>(n.Axis)] < n.Plane * eye[3];
  this->Append(isLowerNear ? n.Lower : n.Upper, eye, order);
  this->Append(isLowerNear ? n.Upper : n.Lower, eye, order);
}

std::vector<int> PieceOrder::Compute(const std::array<double, 4>& eye) const
{
  std::vector<int> order;
  this->Append(this->Root, eye, order);
  this->Append(this->Last, eye, order);
  return order;
}

}

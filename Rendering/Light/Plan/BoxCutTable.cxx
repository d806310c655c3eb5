// SPDX-License-Identifier: BSD-3-Clause
#include "Plan/BoxCutTable.h"

namespace interlume
{

namespace
{

bool IsCut(int edge, unsigned above)
{
  const BoxCutTable::Edge on = BoxCutTable::GetEdge(edge);
  const unsigned end = on.Start | 1u << on.Axis;
  return (above >> on.Start & 1u) != (above >> end & 1u);
}

// Returns whether both edges are at the same place along the axis.
bool IsOnFace(int edge, int axis, unsigned place)
{
  const BoxCutTable::Edge on = BoxCutTable::GetEdge(edge);
  return on.Axis != axis && (on.Start >> axis & 1u) == place;
}

// Returns the cut edge that shares a face with \a edge, other than the one that leads back; -1 if a
// face has more than two.
int FindNext(int edge, int from, unsigned above)
{
  int next = -1;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (unsigned place = 0; place < 2; ++place)
    {
      if (!IsOnFace(edge, axis, place))
      {
        continue;
      }
      int other = -1;
      for (int candidate = 0; candidate < 12; ++candidate)
      {
        if (candidate != edge && IsOnFace(candidate, axis, place) && IsCut(candidate, above))
        {
          if (other >= 0)
          {
            return -1;
          }
          other = candidate;
        }
      }
      next = other >= 0 && other != from ? other : next;
    }
  }
  return next;
}

}

BoxCutTable::Edge BoxCutTable::GetEdge(int edge)
{
  const int axis = edge / 4;
  const int across = (axis + 1) % 3;
  const int up = (axis + 2) % 3;
  const auto places = static_cast<unsigned>(edge % 4);
  return { axis, (places & 1u) << across | (places >> 1 & 1u) << up };
}

BoxCutTable::BoxCutTable()
{
  for (unsigned above = 0; above < this->Edges.size(); ++above)
  {
    std::vector<int>& edges = this->Edges[above];
    int cut = 0;
    int first = -1;
    for (int edge = 11; edge >= 0; --edge)
    {
      if (IsCut(edge, above))
      {
        first = edge;
        ++cut;
      }
    }
    int from = -1;
    for (int edge = first; edge >= 0 && static_cast<int>(edges.size()) < cut;)
    {
      edges.push_back(edge);
      const int next = FindNext(edge, from, above);
      from = edge;
      edge = next == first ? -1 : next;
    }
    // A second loop, or one that is not closed, does not come from a plane.
    if (static_cast<int>(edges.size()) != cut || cut > 6)
    {
      edges.clear();
    }
  }
}

}

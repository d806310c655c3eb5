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

// Returns true if the edge lies on the face at \a position along \a axis.
bool IsOnFace(int edge, int axis, unsigned position)
{
  const BoxCutTable::Edge on = BoxCutTable::GetEdge(edge);
  return on.Axis != axis && (on.Start >> axis & 1u) == position;
}

// Returns the next cut edge around the polygon: it shares a face with \a edge and is not \a from.
// Returns -1 if a face has more than two cut edges.
int FindNext(int edge, int from, unsigned above)
{
  int next = -1;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (unsigned position = 0; position < 2; ++position)
    {
      if (!IsOnFace(edge, axis, position))
      {
        continue;
      }
      int other = -1;
      for (int candidate = 0; candidate < 12; ++candidate)
      {
        if (candidate != edge && IsOnFace(candidate, axis, position) && IsCut(candidate, above))
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
  const auto positions = static_cast<unsigned>(edge % 4);
  return { axis, (positions & 1u) << across | (positions >> 1 & 1u) << up };
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
    // A plane produces one closed loop. Clear any other case.
    if (static_cast<int>(edges.size()) != cut || cut > 6)
    {
      edges.clear();
    }
  }
}

}

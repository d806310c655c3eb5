// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CoincidentSlots_h
#define interlume_CoincidentSlots_h

#include "Scalars/ExtractionValues.h"

#include "vtkIsotable.h"

#include <vector>

namespace interlume
{

/**
 * @class   CoincidentSlots
 * @brief   identifies the slots of a cell that are the same point because a value equals an
 * isovalue
 *
 * If an isovalue crosses an edge at one of its ends, the crossing is the grid point at that end. If
 * an interval has zero width, its lower and upper bounds cross an edge at the same point.
 */
class CoincidentSlots
{
public:
  using Code = ExtractionValues::Code;
  using Slot = vtkIsotable::Slot;

  /// Returns the slot that represents all slots of the same point as \a slot. \a table is a
  /// vtkIsotable or a SpaceTimeTable.
  template <typename Table>
  static Slot FindRepresentative(
    const Table& table, const ExtractionValues::Item& item, const Code* codes, Slot slot)
  {
    const int n = table.GetNumberOfVertices();
    const int m = table.GetNumberOfEdges();
    if (slot < n)
    {
      return slot;
    }
    const int kind = (slot - n) / m;
    const auto& edge = table.GetEdge(slot - n - kind * m);
    const int tie = 2 * (kind == 0 ? item.Lower : item.Upper) + 1;
    for (Slot end : edge)
    {
      if (codes[end] == tie)
      {
        return end;
      }
    }
    return kind == 1 && item.IsFlat ? static_cast<Slot>(slot - m) : slot;
  }

  /**
   * Sets same[slot], for each of \a slots, to the first slot that is the same point. If \a
   * hasEqualCorners is true, corners of the cell may coincide, and slots with equal getPoint(slot)
   * are the same point.
   */
  template <typename Table, typename GetPoint>
  static void FindRepresentatives(const Table& table, const ExtractionValues::Item& item,
    const Code* codes, const std::vector<Slot>& slots, bool hasEqualCorners, GetPoint&& getPoint,
    Slot* same)
  {
    for (const Slot slot : slots)
    {
      same[slot] = FindRepresentative(table, item, codes, slot);
      for (Slot earlier = 0; hasEqualCorners && earlier < same[slot]; ++earlier)
      {
        if (getPoint(earlier) == getPoint(same[slot]))
        {
          same[slot] = earlier;
        }
      }
    }
  }

  /// Returns the key of the interval case in which all vertices are inside.
  static int GetAllInsideKey(int vertices)
  {
    int key = 0;
    for (int v = 0; v < vertices; ++v)
    {
      key = 3 * key + 1;
    }
    return key;
  }

  template <typename Id>
  static bool IsCollapsed(const Id* ids, int number)
  {
    for (int i = 0; i < number; ++i)
    {
      for (int j = i + 1; j < number; ++j)
      {
        if (ids[i] == ids[j])
        {
          return true;
        }
      }
    }
    return false;
  }
};

}

#endif

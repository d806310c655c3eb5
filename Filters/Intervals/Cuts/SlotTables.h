// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SlotTables_h
#define interlume_SlotTables_h

#include "Cuts/CoincidentSlots.h"
#include "Output/CrossingKey.h"
#include "Scalars/ExtractionValues.h"

#include "vtkIsotable.h"
#include "vtkType.h"

#include <algorithm>
#include <numeric>

namespace interlume
{

/**
 * A cell that an item (a contour or an interval) may intersect, with its corners in the vertex
 * order of the table of its shape. \a Steps is the number of time steps, 1 or 2. With two steps,
 * the corners at the first step precede those at the second.
 */
template <int Steps>
struct TableCell
{
  using Code = ExtractionValues::Code;
  static constexpr int MaximumNumberOfVertices = Steps * vtkIsotable::MaximumNumberOfVertices;

  vtkIdType Id = -1;
  vtkIsotable::Shapes Shape = vtkIsotable::HEXAHEDRON;
  /// Number of corners at one time step.
  int NumberOfCorners = 8;
  vtkIdType Ids[MaximumNumberOfVertices] = {};
  Code Codes[MaximumNumberOfVertices] = {};
  /// If true, the corner ids are in ascending order, and the cut stored in the table applies.
  bool IsAscending = true;
  /// If true, reordering a tetrahedron or triangle has reversed its orientation.
  bool IsReflected = false;

  int GetNumberOfVertices() const { return Steps * this->NumberOfCorners; }

  /// Returns true if two corners are the same point.
  bool HasEqualCorners() const
  {
    return !this->IsAscending && CoincidentSlots::IsCollapsed(this->Ids, this->NumberOfCorners);
  }
};

/**
 * @class   SlotTables
 * @brief   the tables of all cell shapes, and the points at which their slots lie
 *
 * \a Table is vtkIsotable or SpaceTimeTable.
 */
template <typename Table>
class SlotTables
{
public:
  using Item = ExtractionValues::Item;
  using Slot = vtkIsotable::Slot;
  static constexpr int MaximumNumberOfSlots = Table::MaximumNumberOfSlots;

  /// The ends of a slot's edge, and whether the slot is the crossing of the upper isovalue.
  struct SlotEnds
  {
    Slot A;
    Slot B;
    bool IsUpper;
  };

  /// Initializes the tables of the first \a number shapes with getTable(shape).
  template <typename GetTable>
  SlotTables(int number, GetTable&& getTable)
  {
    for (int shape = 0; shape < number; ++shape)
    {
      const Table& table = getTable(static_cast<vtkIsotable::Shapes>(shape));
      this->Tables[shape] = &table;
      const int n = table.GetNumberOfVertices();
      const int m = table.GetNumberOfEdges();
      for (int slot = n; slot < n + 2 * m; ++slot)
      {
        const auto& edge = table.GetEdge((slot - n) % m);
        this->Ends[shape][slot] = { edge[0], edge[1], slot >= n + m };
      }
    }
  }

  const Table& operator[](vtkIsotable::Shapes shape) const { return *this->Tables[shape]; }

  const SlotEnds& GetEnds(vtkIsotable::Shapes shape, Slot slot) const
  {
    return this->Ends[shape][slot];
  }

  /// Returns the key of a slot's point, and sets \a owner to the grid point that owns the point.
  template <typename Cell>
  CrossingKey GetPoint(const Cell& cell, const Item& item, Slot slot, vtkIdType& owner) const
  {
    if (slot < cell.GetNumberOfVertices())
    {
      owner = cell.Ids[slot];
      return {};
    }
    const SlotEnds& ends = this->Ends[cell.Shape][slot];
    const vtkIdType a = cell.Ids[ends.A];
    const vtkIdType b = cell.Ids[ends.B];
    owner = std::min(a, b);
    return { std::max(a, b), ends.IsUpper ? item.Upper : item.Lower };
  }

  /// Finds the slots of a case that are the same point because a value equals an isovalue or two
  /// corners coincide. \a same maps each slot to the one that represents its point. Returns false
  /// if all slots are distinct points.
  template <typename Cell>
  bool Merge(const Cell& cell, const Item& item, const typename Table::Case& what, Slot* same) const
  {
    typename Cell::Code ties = item.IsFlat;
    for (int v = 0; v < cell.GetNumberOfVertices(); ++v)
    {
      ties |= cell.Codes[v];
    }
    const bool hasEqualCorners = cell.HasEqualCorners();
    if (!ExtractionValues::IsTie(ties) && !hasEqualCorners)
    {
      return false;
    }
    std::iota(same, same + MaximumNumberOfSlots, Slot(0));
    CoincidentSlots::FindRepresentatives((*this)[cell.Shape], item, cell.Codes, what.Slots,
      hasEqualCorners,
      [&](Slot slot)
      {
        vtkIdType owner;
        const CrossingKey key = this->GetPoint(cell, item, slot, owner);
        return std::make_pair(owner, key);
      },
      same);
    return std::any_of(
      what.Slots.begin(), what.Slots.end(), [same](Slot slot) { return same[slot] != slot; });
  }

private:
  const Table* Tables[vtkIsotable::NUMBER_OF_SHAPES] = {};
  SlotEnds Ends[vtkIsotable::NUMBER_OF_SHAPES][MaximumNumberOfSlots];
};

}

#endif

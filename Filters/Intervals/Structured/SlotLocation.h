// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SlotLocation_h
#define interlume_SlotLocation_h

#include "vtkIsotable.h"

#include <vector>

namespace interlume
{

class ExtractionValues;

/**
 * @class   SlotLocation
 * @brief   location of a slot of the hexahedron table in the rows around a cell
 */
struct SlotLocation
{
  using Slot = vtkIsotable::Slot;

  /// Row of the owner: 0 (j,k), 1 (j+1,k), 2 (j,k+1), 3 (j+1,k+1).
  Slot Row;
  /// Column of the owner relative to the cell: 0 or 1.
  Slot Column;
  /// 0: the grid point itself; 1, 2, 3: its edge along i, j, k.
  Slot Direction;
  /// 0: lower isovalue, 1: upper isovalue.
  Slot Kind;
  /// End points of the edge, as vertices of the cell.
  Slot Ends[2];
  /// If true, points of other isovalues may precede this point on the edge.
  bool MayFollow;

  /// Returns the locations of all slots.
  static std::vector<SlotLocation> FindAll(
    const vtkIsotable& table, const ExtractionValues& values);

  /// Returns the ranks of the slots for cells whose vertex ids are in ascending order, as in a
  /// structured grid.
  static vtkIsotable::RankArray FindRanks(const vtkIsotable& table);
};

}

#endif

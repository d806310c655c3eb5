// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SlotPlace_h
#define interlume_SlotPlace_h

#include "vtkIsotable.h"

#include <vector>

namespace interlume
{

class ExtractionValues;

/**
 * @class   SlotPlace
 * @brief   the place of a slot of the hexahedron's table in the rows around a cell
 */
struct SlotPlace
{
  using Slot = vtkIsotable::Slot;

  /// Of the owner: 0 (j,k), 1 (j+1,k), 2 (j,k+1), 3 (j+1,k+1).
  Slot Row;
  /// Of the owner: 0 or 1.
  Slot Column;
  /// 0: the grid point itself, 1, 2, 3: the edge along i, j, k.
  Slot Direction;
  /// 0: lower, 1: upper isovalue.
  Slot Kind;
  /// Vertices of the cell.
  Slot Ends[2];
  /// Whether points of other isovalues may come before on the edge.
  bool MayFollow;

  /// Returns the places of all slots.
  static std::vector<SlotPlace> FindAll(const vtkIsotable& table, const ExtractionValues& values);

  /// Returns the order of slots in rows, where a cell's vertices ascend.
  static vtkIsotable::RankArray FindRanks(const vtkIsotable& table);
};

}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CellFinding_h
#define interlume_CellFinding_h

#include "vtkType.h"

#include <cstdint>
#include <tuple>

namespace interlume
{

/**
 * @class   CellFinding
 * @brief   the cell that a search has found at a position, and what it is compared by with others
 *
 * Of the cells that several searches have found the first counts: one that Newton's method finds
 * from one start before those that it finds from several, then the one that the position is least
 * outside of, then by CellTree's order, then by the cell's number. So the cells may be searched
 * together, or those of each process by itself.
 */
struct CellFinding
{
  bool IsFound = false;
  bool IsFromSeveral = false;
  /// How far the place is outside of the cell; 0 inside.
  double Outside = 0.0;
  std::uint64_t Order = 0;
  vtkIdType Cell = -1;
  /// The place in the cell.
  double P[3] = { 0.0, 0.0, 0.0 };

  bool IsBefore(const CellFinding& other) const
  {
    return this->IsFound &&
      (!other.IsFound ||
        std::tie(this->IsFromSeveral, this->Outside, this->Order, this->Cell) <
          std::tie(other.IsFromSeveral, other.Outside, other.Order, other.Cell));
  }
};

}

#endif

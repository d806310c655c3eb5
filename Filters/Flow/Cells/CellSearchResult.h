// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CellSearchResult_h
#define interlume_CellSearchResult_h

#include "vtkType.h"

#include <cstdint>
#include <tuple>

namespace interlume
{

/**
 * @class   CellSearchResult
 * @brief   cell that a search found at a position, with criteria for comparison with other results
 *
 * IsBefore returns true if this result is preferable to another result. Cells found by Newton's
 * method from one starting point are preferable to cells found from several starting points.
 * Further criteria are the distance by which the position is outside the cell, the order of
 * CellTree, and the cell id. This total order makes the result independent of the partition of the
 * cells among processes.
 */
struct CellSearchResult
{
  bool IsFound = false;
  bool IsFromSeveral = false;
  /// Parametric distance by which the position is outside the cell, or 0 inside.
  double Outside = 0.0;
  std::uint64_t Order = 0;
  vtkIdType Cell = -1;
  /// Parametric coordinates in the cell.
  double P[3] = { 0.0, 0.0, 0.0 };

  bool IsBefore(const CellSearchResult& other) const
  {
    return this->IsFound &&
      (!other.IsFound ||
        std::tie(this->IsFromSeveral, this->Outside, this->Order, this->Cell) <
          std::tie(other.IsFromSeveral, other.Outside, other.Order, other.Cell));
  }
};

}

#endif

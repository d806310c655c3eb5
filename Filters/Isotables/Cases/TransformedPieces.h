// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TransformedPieces_h
#define interlume_TransformedPieces_h

#include "Cases/CellSymmetries.h"

#include "vtkIsotable.h"

#include <vector>

namespace interlume
{

/**
 * @class   TransformedPieces
 * @brief   transforms the pieces of an interval case by a symmetry of the cell
 *
 * The result is identical to the pieces computed from the hull of the transformed case. A hull
 * lists points, faces and pieces in the order of the lifted cell's edges that identify them, so the
 * transformed pieces are sorted in this order.
 */
class TransformedPieces
{
public:
  using Slot = vtkIsotable::Slot;

  /// Returns the transformed pieces of a cell with \a vertices vertices and \a edges edges, in the
  /// format of vtkIsotable::Case.
  static std::vector<Slot> Move(const std::vector<Slot>& pieces,
    const CellSymmetries::Symmetry& symmetry, int vertices, int edges);
};

}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_MovedPieces_h
#define interlume_MovedPieces_h

#include "Cases/CellSymmetries.h"

#include "vtkIsotable.h"

#include <vector>

namespace interlume
{

/**
 * @class   MovedPieces
 * @brief   moves the pieces of an interval's case by a symmetry of the cell
 *
 * The result is, number by number, what the hull of the moved case gives: that lists points, faces
 * and pieces in the order of their sets of lifted edges, so that they only have to be sorted again.
 */
class MovedPieces
{
public:
  using Slot = vtkIsotable::Slot;

  /// Returns the moved pieces of a cell of \a vertices and \a edges, in the form of
  /// vtkIsotable::Case.
  static std::vector<Slot> Move(const std::vector<Slot>& pieces,
    const CellSymmetries::Symmetry& symmetry, int vertices, int edges);
};

}

#endif

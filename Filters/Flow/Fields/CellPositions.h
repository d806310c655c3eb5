// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CellPositions_h
#define interlume_CellPositions_h

#include "Cells/CellTree.h"
#include "Common/ArrayRows.h"
#include "Common/Error.h"

#include <functional>

namespace interlume
{

/**
 * @class   CellPositions
 * @brief   the positions of cells' points: whether they are finite, and a tree of the cells' boxes
 *
 * \a positions must outlive this object.
 */
class CellPositions
{
public:
  /// A function that gives the points of a cell, at most eight, and returns their number; 0 for a
  /// cell to leave out.
  using CellPoints = std::function<int(vtkIdType cell, vtkIdType* points)>;

  CellPositions(const ArrayRows& positions, CellPoints getPoints);

  /// Returns an error that names the first point of the first cell that is not finite, if any.
  Error FindError(vtkIdType numberOfCells) const;
  void Build(vtkIdType numberOfCells, CellTree& tree, const CellTree::Unite& unite = {}) const;

private:
  vtkIdType FindPoint(vtkIdType cell) const;

  const ArrayRows& Positions;
  CellPoints GetPoints;
};

}

#endif

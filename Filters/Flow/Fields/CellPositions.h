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
 * @brief   checks point positions of cells, and builds a tree of the cells' bounding boxes
 *
 * \a positions must outlive this object.
 */
class CellPositions
{
public:
  /// Callback that computes the points of a cell, at most eight, and returns their number, or 0 to
  /// exclude the cell.
  using CellPoints = std::function<int(vtkIdType cell, vtkIdType* points)>;

  CellPositions(const ArrayRows& positions, CellPoints getPoints);

  /// Returns an error that names the first non-finite point of the first cell that has one.
  Error FindError(vtkIdType numberOfCells) const;
  /// Builds the tree.
  void Build(vtkIdType numberOfCells, CellTree& tree, const CellTree::Unite& unite = {}) const;

private:
  vtkIdType FindPoint(vtkIdType cell) const;

  const ArrayRows& Positions;
  CellPoints GetPoints;
};

}

#endif

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
 * @brief   checks the point positions of cells, and builds a CellTree of the bounding boxes
 *
 * \a positions must outlive this object.
 */
class CellPositions
{
public:
  /// Callback that writes the point ids of a cell, at most eight, to \a points and returns their
  /// number, or 0 to exclude the cell.
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

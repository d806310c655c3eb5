#ifndef vtkCellPositions_h
#define vtkCellPositions_h

#include "vtkCellTree.h"
#include "vtkFlowValues.h"

#include <functional>
#include <string>

/**
 * @class   vtkCellPositions
 * @brief   where the points of cells are: whether they are finite, and a tree of the cells' boxes
 *
 * \a positions must outlive it.
 */
class INTERLUMEFLOW_EXPORT vtkCellPositions
{
public:
  /// The points of a cell, at most eight; 0 for a cell to leave out.
  using CellPoints = std::function<int(vtkIdType cell, vtkIdType* points)>;

  vtkCellPositions(const vtkFlowValues& positions, CellPoints getPoints);

  /// Names the first point of the first cell that is not finite; nothing without one.
  std::string FindError(vtkIdType numberOfCells) const;
  void Build(vtkIdType numberOfCells, vtkCellTree& tree) const;

private:
  vtkIdType FindPoint(vtkIdType cell) const;

  const vtkFlowValues& Positions;
  CellPoints GetPoints;
};

#endif

// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/CellPositions.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

namespace interlume
{

CellPositions::CellPositions(const ArrayRows& positions, CellPoints getPoints)
  : Positions(positions)
  , GetPoints(std::move(getPoints))
{
}

vtkIdType CellPositions::FindPoint(vtkIdType cell) const
{
  vtkIdType points[8];
  const int number = this->GetPoints(cell, points);
  for (int v = 0; v < number; ++v)
  {
    double x[3];
    this->Positions.Get<3>(points[v], x);
    if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
    {
      return points[v];
    }
  }
  return -1;
}

Error CellPositions::FindError(vtkIdType numberOfCells) const
{
  std::atomic<vtkIdType> firstInvalid(numberOfCells);
  vtkSMPTools::For(0, numberOfCells,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType cell = first; cell < last && cell < firstInvalid; ++cell)
      {
        if (this->FindPoint(cell) >= 0)
        {
          vtkIdType known = firstInvalid;
          while (cell < known && !firstInvalid.compare_exchange_weak(known, cell))
          {
          }
        }
      }
    });
  return firstInvalid == numberOfCells
    ? Error()
    : "point " + std::to_string(this->FindPoint(firstInvalid)) + " is not finite";
}

void CellPositions::Build(
  vtkIdType numberOfCells, CellTree& tree, const CellTree::Unite& unite) const
{
  tree.Build(
    numberOfCells,
    [this](vtkIdType cell, double box[6])
    {
      vtkIdType points[8];
      const int number = this->GetPoints(cell, points);
      for (int v = 0; v < number; ++v)
      {
        double x[3];
        this->Positions.Get<3>(points[v], x);
        for (int axis = 0; axis < 3; ++axis)
        {
          box[2 * axis] = v > 0 ? std::min(box[2 * axis], x[axis]) : x[axis];
          box[2 * axis + 1] = v > 0 ? std::max(box[2 * axis + 1], x[axis]) : x[axis];
        }
      }
      return number > 0;
    },
    unite);
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/RectilinearFlowField.h"

#include "Common/AxisCheck.h"

#include "vtkDataArray.h"
#include "vtkRectilinearGrid.h"

#include <cfloat>
#include <cmath>

namespace interlume
{

Error RectilinearFlowField::Build(vtkRectilinearGrid* grid, vtkDataArray* vectors,
  const std::vector<vtkDataArray*>& arrays, const StageProgress& progress,
  const FieldPartition* part)
{
  int points[3];
  grid->GetDimensions(points);
  if (Error error = this->BuildTopologyAndArrays(grid, points, vectors, arrays, progress, part))
  {
    return error;
  }
  vtkRectilinearGrid* fullGrid = part ? vtkRectilinearGrid::SafeDownCast(part->FullGrid) : grid;
  fullGrid->GetDimensions(points);
  vtkDataArray* const coordinates[3] = { fullGrid->GetXCoordinates(), fullGrid->GetYCoordinates(),
    fullGrid->GetZCoordinates() };
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!coordinates[axis] || coordinates[axis]->GetNumberOfTuples() < points[axis])
    {
      return std::string("there are too few coordinates along ") + "xyz"[axis];
    }
    std::vector<double>& values = this->Coordinates[axis];
    values.resize(points[axis]);
    for (int i = 0; i < points[axis]; ++i)
    {
      values[i] = coordinates[axis]->GetTuple1(i);
      if (!std::isfinite(values[i]))
      {
        return "coordinate " + std::to_string(i) + " along " + "xyz"[axis] + " is not finite";
      }
    }
    const AxisCheck turns = AxisCheck::Find(coordinates[axis], points[axis]);
    if (turns.Number > 0)
    {
      return turns.Describe(axis, coordinates[axis]);
    }
    this->Magnitude[axis] = std::max(std::abs(values.front()), std::abs(values.back()));
  }
  return {};
}

void RectilinearFlowField::GetContinuousIndex(const double x[3], double q[3], double slack[3]) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::vector<double>& values = this->Coordinates[axis];
    const bool isAscending = values[1] > values[0];
    const auto next = std::upper_bound(values.begin() + 1, values.end() - 1, x[axis],
      [isAscending](double a, double b) { return isAscending ? a < b : a > b; });
    const double width = *next - *(next - 1);
    q[axis] = static_cast<double>(next - 1 - values.begin()) + (x[axis] - *(next - 1)) / width;
    slack[axis] = 1e-12 + 8.0 * DBL_EPSILON * this->Magnitude[axis] / std::abs(width);
  }
}

bool RectilinearFlowField::Locate(const double x[3], CellLocation& location, double p[3]) const
{
  double q[3];
  double slack[3];
  this->GetContinuousIndex(x, q, slack);
  return this->Find(q, slack, location, p);
}

bool RectilinearFlowField::LocateIndex(const double x[3], int index[3], double p[3]) const
{
  double q[3];
  double slack[3];
  this->GetContinuousIndex(x, q, slack);
  return this->FindIndex(q, slack, index, p);
}

}

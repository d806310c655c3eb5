// SPDX-License-Identifier: BSD-3-Clause
#include "ParaView/Extractions/ExtractionMeasures.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
using Vector = std::array<double, 4>;

// From one point of a grid to another in space and, where there are times, in time.
Vector Edge(vtkPoints* points, vtkDataArray* times, vtkIdType from, vtkIdType to)
{
  Vector a{};
  Vector b{};
  points->GetPoint(from, a.data());
  points->GetPoint(to, b.data());
  if (times)
  {
    a[3] = times->GetTuple1(from);
    b[3] = times->GetTuple1(to);
  }
  return { b[0] - a[0], b[1] - a[1], b[2] - a[2], b[3] - a[3] };
}

double SizeOfSimplex(vtkPoints* points, vtkDataArray* times, vtkIdList* ids)
{
  std::array<Vector, 4> edges{};
  for (vtkIdType i = 1; i < ids->GetNumberOfIds(); ++i)
  {
    edges[i - 1] = Edge(points, times, ids->GetId(0), ids->GetId(i));
  }
  if (ids->GetNumberOfIds() == 5)
  {
    return vtkMatrix4x4::Determinant(edges.front().data()) / 24.0;
  }
  double normal[3];
  vtkMath::Cross(edges[0].data(), edges[1].data(), normal);
  return ids->GetNumberOfIds() == 3 ? vtkMath::Norm(normal) / 2.0
                                    : vtkMath::Dot(normal, edges[2].data()) / 6.0;
}

double MeanOver(vtkDataArray* array, vtkIdList* ids)
{
  double sum = 0.0;
  for (const vtkIdType id : *ids)
  {
    sum += array->GetTuple1(id);
  }
  return sum / static_cast<double>(ids->GetNumberOfIds());
}

nlohmann::json ArrayRanges(vtkDataSetAttributes* attributes)
{
  nlohmann::json ranges = nlohmann::json::object();
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    const double* range = attributes->GetArray(i)->GetRange();
    ranges[attributes->GetArrayName(i)] = { range[0], range[1] };
  }
  return ranges;
}

struct Group
{
  vtkIdType Cells = 0;
  double Size = 0.0;
};
}

nlohmann::json MeasureExtraction(vtkUnstructuredGrid* grid, const char* idArray)
{
  vtkDataArray* ids = grid->GetCellData()->GetArray(idArray);
  if (!ids)
  {
    throw std::runtime_error(std::string("no cell array ") + idArray);
  }
  vtkDataArray* times = grid->GetPointData()->GetArray("Time");
  vtkDataArray* durations = grid->GetPointData()->GetArray("DeltaT");
  double size = 0.0;
  double hypervolume = 0.0;
  std::map<int, Group> groups;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    grid->GetCellPoints(cell, corners);
    const double sizeOfCell = SizeOfSimplex(grid->GetPoints(), times, corners);
    Group& group = groups[static_cast<int>(ids->GetTuple1(cell))];
    ++group.Cells;
    group.Size += sizeOfCell;
    size += sizeOfCell;
    hypervolume += durations ? sizeOfCell * MeanOver(durations, corners) : 0.0;
  }
  nlohmann::json byId = nlohmann::json::array();
  for (const auto& entry : groups)
  {
    byId.push_back(
      { { "id", entry.first }, { "cells", entry.second.Cells }, { "size", entry.second.Size } });
  }
  const double* bounds = grid->GetBounds();
  return { { "points", grid->GetNumberOfPoints() }, { "cells", grid->GetNumberOfCells() },
    { "bounds", std::vector<double>(bounds, bounds + 6) }, { "size", size },
    { "hypervolume", hypervolume }, { "by_id", byId },
    { "ranges",
      { { "point", ArrayRanges(grid->GetPointData()) },
        { "cell", ArrayRanges(grid->GetCellData()) } } } };
}

#include "ExtractionMeasures.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
using Vector = std::array<double, 3>;

Vector Edge(vtkPoints* points, vtkIdType from, vtkIdType to)
{
  Vector a;
  Vector b;
  points->GetPoint(from, a.data());
  points->GetPoint(to, b.data());
  return { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
}

double SizeOfSimplex(vtkPoints* points, vtkIdList* ids)
{
  const Vector u = Edge(points, ids->GetId(0), ids->GetId(1));
  const Vector v = Edge(points, ids->GetId(0), ids->GetId(2));
  Vector normal;
  vtkMath::Cross(u.data(), v.data(), normal.data());
  if (ids->GetNumberOfIds() == 3)
  {
    return vtkMath::Norm(normal.data()) / 2.0;
  }
  const Vector w = Edge(points, ids->GetId(0), ids->GetId(3));
  return vtkMath::Dot(normal.data(), w.data()) / 6.0;
}

std::vector<std::string> SortedArrayNames(vtkDataSetAttributes* attributes)
{
  std::vector<std::string> names;
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    names.emplace_back(attributes->GetArrayName(i));
  }
  std::sort(names.begin(), names.end());
  return names;
}
}

nlohmann::json MeasureExtraction(vtkUnstructuredGrid* grid, const char* idArray)
{
  vtkDataArray* ids = grid->GetCellData()->GetArray(idArray);
  if (!ids)
  {
    throw std::runtime_error(std::string("no cell array ") + idArray);
  }
  double size = 0.0;
  std::map<int, vtkIdType> cellsById;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    grid->GetCellPoints(cell, corners);
    size += SizeOfSimplex(grid->GetPoints(), corners);
    ++cellsById[static_cast<int>(ids->GetTuple1(cell))];
  }
  std::vector<vtkIdType> counts;
  for (const auto& entry : cellsById)
  {
    counts.push_back(entry.second);
  }
  const double* bounds = grid->GetBounds();
  return { { "points", grid->GetNumberOfPoints() }, { "cells", grid->GetNumberOfCells() },
    { "bounds", std::vector<double>(bounds, bounds + 6) }, { "size", size },
    { "cells_by_id", counts },
    { "arrays",
      { { "point", SortedArrayNames(grid->GetPointData()) },
        { "cell", SortedArrayNames(grid->GetCellData()) } } } };
}

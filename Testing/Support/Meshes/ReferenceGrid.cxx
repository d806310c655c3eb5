// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Meshes/ReferenceGrid.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "Common/GridCells.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <cstring>
#include <functional>
#include <stdexcept>

namespace reference
{

namespace
{

template <size_t N>
std::vector<std::array<vtkIdType, N>> CellsOf(
  vtkUnstructuredGrid* grid, const std::function<bool(vtkIdType)>& wanted)
{
  std::vector<std::array<vtkIdType, N>> cells;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    vtkIdType count;
    const vtkIdType* ids;
    grid->GetCellPoints(cell, count, ids);
    if (count == static_cast<vtkIdType>(N) && wanted(cell))
    {
      std::array<vtkIdType, N> simplex;
      std::copy(ids, ids + N, simplex.begin());
      cells.push_back(simplex);
    }
  }
  return cells;
}

std::string CompareArrays(vtkAbstractArray* a, vtkAbstractArray* b, const std::string& name)
{
  if (!a || !b)
  {
    return a == b ? "" : name + " is in one grid only";
  }
  if (a->GetDataType() != b->GetDataType() ||
    a->GetNumberOfComponents() != b->GetNumberOfComponents() ||
    a->GetNumberOfTuples() != b->GetNumberOfTuples())
  {
    return name + " differs in type or size";
  }
  if (auto* strings = vtkStringArray::SafeDownCast(a))
  {
    auto* others = vtkStringArray::SafeDownCast(b);
    for (vtkIdType i = 0; i < strings->GetNumberOfValues(); ++i)
    {
      if (strings->GetValue(i) != others->GetValue(i))
      {
        return name + " differs at " + std::to_string(i);
      }
    }
    return "";
  }
  const size_t bytes = static_cast<size_t>(a->GetNumberOfValues()) * a->GetDataTypeSize();
  return bytes > 0 && std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0), bytes) != 0
    ? name + " differs in its values"
    : "";
}

std::string CompareAttributes(
  vtkDataSetAttributes* a, vtkDataSetAttributes* b, const std::string& kind)
{
  if (a->GetNumberOfArrays() != b->GetNumberOfArrays())
  {
    return "the number of " + kind + " arrays differs";
  }
  for (int i = 0; i < a->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = a->GetAbstractArray(i);
    const std::string name = array->GetName() ? array->GetName() : "";
    const std::string difference =
      CompareArrays(array, b->GetAbstractArray(i), kind + " array " + name);
    if (!difference.empty())
    {
      return difference;
    }
  }
  return "";
}

}

std::vector<Tetrahedron> TetrahedraOf(vtkUnstructuredGrid* grid, int interval)
{
  vtkDataArray* intervals = grid->GetCellData()->GetArray("IntervalId");
  return CellsOf<4>(grid,
    [&](vtkIdType cell) { return intervals && intervals->GetComponent(cell, 0) == interval; });
}

std::vector<Triangle> BoundaryOf(vtkUnstructuredGrid* grid, int interval, int side)
{
  vtkDataArray* intervals = grid->GetCellData()->GetArray("IntervalId");
  vtkDataArray* sides = grid->GetCellData()->GetArray("BoundarySide");
  return CellsOf<3>(grid,
    [&](vtkIdType cell)
    {
      return intervals && sides && intervals->GetComponent(cell, 0) == interval &&
        sides->GetComponent(cell, 0) == side;
    });
}

std::vector<Triangle> TrianglesOf(vtkUnstructuredGrid* grid)
{
  return CellsOf<3>(grid, [](vtkIdType) { return true; });
}

std::vector<Triangle> Reversed(std::vector<Triangle> triangles)
{
  for (Triangle& triangle : triangles)
  {
    std::swap(triangle[1], triangle[2]);
  }
  return triangles;
}

bool IsValid(vtkUnstructuredGrid* grid, int type)
{
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    vtkIdType count;
    const vtkIdType* ids;
    grid->GetCellPoints(cell, count, ids);
    if (grid->GetCellType(cell) != type ||
      std::any_of(
        ids, ids + count, [&](vtkIdType id) { return id < 0 || id >= grid->GetNumberOfPoints(); }))
    {
      return false;
    }
  }
  return true;
}

std::vector<GeometricSimplex> GeometricSet(
  vtkUnstructuredGrid* grid, const std::vector<std::string>& cellArrays, const std::string& fourth)
{
  const auto find = [&](vtkDataSetAttributes* attributes, const std::string& name)
  {
    vtkDataArray* array = attributes->GetArray(name.c_str());
    if (!array && grid->GetNumberOfCells() > 0)
    {
      throw std::invalid_argument("no array " + name);
    }
    return array;
  };
  std::vector<vtkDataArray*> arrays;
  arrays.reserve(cellArrays.size());
  for (const std::string& name : cellArrays)
  {
    arrays.push_back(find(grid->GetCellData(), name));
  }
  vtkDataArray* const fourths = fourth.empty() ? nullptr : find(grid->GetPointData(), fourth);
  std::vector<GeometricSimplex> set;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    vtkIdType count;
    const vtkIdType* ids;
    grid->GetCellPoints(cell, count, ids);
    std::vector<std::array<double, 4>> points(count);
    for (vtkIdType i = 0; i < count; ++i)
    {
      grid->GetPoint(ids[i], points[i].data());
      points[i][3] = fourths ? fourths->GetComponent(ids[i], 0) : 0;
    }
    double sign = 1;
    for (size_t i = 1; i < points.size(); ++i)
    {
      for (size_t j = i; j > 0 && points[j] < points[j - 1]; --j)
      {
        std::swap(points[j], points[j - 1]);
        sign = -sign;
      }
    }
    GeometricSimplex simplex = { sign };
    for (const auto& point : points)
    {
      simplex.insert(simplex.end(), point.begin(), point.end() - (fourths ? 0 : 1));
    }
    for (vtkDataArray* array : arrays)
    {
      simplex.push_back(array->GetComponent(cell, 0));
    }
    set.push_back(simplex);
  }
  std::sort(set.begin(), set.end());
  return set;
}

std::string FindDifference(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b)
{
  if (a->GetNumberOfPoints() != b->GetNumberOfPoints() ||
    a->GetNumberOfCells() != b->GetNumberOfCells())
  {
    return "the number of points or cells differs";
  }
  if (a->GetNumberOfPoints() == 0)
  {
    return "";
  }
  const std::string parts[] = { CompareArrays(
                                  a->GetPoints()->GetData(), b->GetPoints()->GetData(), "points"),
    CompareArrays(
      a->GetCells()->GetConnectivityArray(), b->GetCells()->GetConnectivityArray(), "connectivity"),
    CompareArrays(a->GetCells()->GetOffsetsArray(), b->GetCells()->GetOffsetsArray(), "offsets"),
    CompareArrays(
      interlume::GridCells::GetTypes(a), interlume::GridCells::GetTypes(b), "cell types"),
    CompareAttributes(a->GetPointData(), b->GetPointData(), "point"),
    CompareAttributes(a->GetCellData(), b->GetCellData(), "cell") };
  for (const std::string& difference : parts)
  {
    if (!difference.empty())
    {
      return difference;
    }
  }
  return "";
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Support/TimeVarying/ReferenceSimplices.h"

#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceVolume.h"
#include "Support/TimeVarying/ReferenceSpaceTime.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

namespace reference
{

namespace
{

using Real = long double;

vtkDataArray* GetArray(vtkDataSetAttributes* attributes, const char* name)
{
  vtkDataArray* array = attributes->GetArray(name);
  if (!array)
  {
    throw std::invalid_argument("no array " + std::string(name));
  }
  return array;
}

/// Calls \a visit for each cell with N points that has the given interval and the value \a number
/// in the cell array \a array.
template <size_t N>
void ForEachSimplex(vtkUnstructuredGrid* grid, int interval, const char* array, int number,
  const std::function<void(vtkIdType, const std::array<vtkIdType, N>&)>& visit)
{
  if (grid->GetNumberOfCells() == 0)
  {
    return;
  }
  vtkDataArray* intervals = GetArray(grid->GetCellData(), "IntervalId");
  vtkDataArray* numbers = GetArray(grid->GetCellData(), array);
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    vtkIdType count;
    const vtkIdType* ids;
    grid->GetCellPoints(cell, count, ids);
    // A tetrahedron at a time step is stored with its last point repeated. It is not a 4-simplex.
    const bool isTetrahedronAtStep = N == 5 && count == 5 && ids[3] == ids[4];
    if (count == static_cast<vtkIdType>(N) && !isTetrahedronAtStep &&
      (interval == Any || intervals->GetComponent(cell, 0) == interval) &&
      (number == Any || numbers->GetComponent(cell, 0) == number))
    {
      std::array<vtkIdType, N> simplex;
      std::copy(ids, ids + N, simplex.begin());
      visit(cell, simplex);
    }
  }
}

std::array<Real, 3> PositionOf(vtkUnstructuredGrid* grid, vtkIdType id)
{
  double x[3];
  grid->GetPoint(id, x);
  return { x[0], x[1], x[2] };
}

void Add(HypervolumeSum& sum, Real hypervolume)
{
  sum.Sum += hypervolume;
  sum.SumOfAbsolute += std::abs(hypervolume);
  ++sum.Count;
}

std::array<std::array<Real, 3>, 4> CornersOf(
  vtkUnstructuredGrid* grid, const Tetrahedron& tetrahedron)
{
  std::array<std::array<Real, 3>, 4> corners;
  for (int i = 0; i < 4; ++i)
  {
    corners[i] = PositionOf(grid, tetrahedron[i]);
  }
  return corners;
}

Real DeterminantOf(const std::array<std::array<Real, 3>, 4>& corners)
{
  return Determinant(corners[0], corners[1], corners[2], corners[3]);
}

}

std::vector<FourSimplex> FourSimplicesOf(vtkUnstructuredGrid* grid, int interval, int slab)
{
  std::vector<FourSimplex> simplices;
  ForEachSimplex<5>(grid, interval, "TimeSlab", slab,
    [&](vtkIdType, const FourSimplex& simplex) { simplices.push_back(simplex); });
  return simplices;
}

bool AreFourSimplices(vtkUnstructuredGrid* grid)
{
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    vtkIdType count;
    const vtkIdType* ids;
    grid->GetCellPoints(cell, count, ids);
    if (count != 5)
    {
      return false;
    }
  }
  return IsValid(grid, VTK_POLY_VERTEX);
}

std::vector<OrientedSimplex<4>> FacesOf(const std::vector<FourSimplex>& simplices)
{
  std::vector<OrientedSimplex<4>> faces;
  faces.reserve(5 * simplices.size());
  for (const FourSimplex& s : simplices)
  {
    // Face i omits point i. If i is odd, two of its points are swapped.
    faces.emplace_back(Tetrahedron{ s[1], s[2], s[3], s[4] });
    faces.emplace_back(Tetrahedron{ s[2], s[0], s[3], s[4] });
    faces.emplace_back(Tetrahedron{ s[0], s[1], s[3], s[4] });
    faces.emplace_back(Tetrahedron{ s[1], s[0], s[2], s[4] });
    faces.emplace_back(Tetrahedron{ s[0], s[1], s[2], s[3] });
  }
  return faces;
}

long double HypervolumeOf(vtkUnstructuredGrid* grid, const FourSimplex& simplex)
{
  vtkDataArray* times = GetArray(grid->GetPointData(), "Time");
  std::array<SpaceTimePoint, 5> points;
  for (int i = 0; i < 5; ++i)
  {
    const std::array<Real, 3> x = PositionOf(grid, simplex[i]);
    points[i] = { x[0], x[1], x[2], times->GetComponent(simplex[i], 0) };
  }
  return SimplexHypervolume(points);
}

template <size_t N>
std::vector<std::array<vtkIdType, N>> BoundaryCellsOf(
  vtkUnstructuredGrid* grid, int interval, int kind)
{
  std::vector<std::array<vtkIdType, N>> cells;
  ForEachSimplex<N>(grid, interval, "BoundaryKind", kind,
    [&](vtkIdType, const std::array<vtkIdType, N>& points) { cells.push_back(points); });
  return cells;
}
template std::vector<Triangle> BoundaryCellsOf<3>(vtkUnstructuredGrid*, int, int);
template std::vector<Tetrahedron> BoundaryCellsOf<4>(vtkUnstructuredGrid*, int, int);

HypervolumeSum MeasureSimplices(vtkUnstructuredGrid* grid, int interval, int slab)
{
  HypervolumeSum sum;
  ForEachSimplex<5>(grid, interval, "TimeSlab", slab,
    [&](vtkIdType, const FourSimplex& simplex) { Add(sum, HypervolumeOf(grid, simplex)); });
  return sum;
}

HypervolumeSum MeasureWeightedTetrahedra(vtkUnstructuredGrid* grid, int interval, int slab)
{
  HypervolumeSum sum;
  for (const WeightedTetrahedron& tetrahedron : WeightedTetrahedraOf(grid, interval, slab))
  {
    Add(sum, tetrahedron.Hypervolume);
  }
  return sum;
}

std::vector<WeightedTetrahedron> WeightedTetrahedraOf(
  vtkUnstructuredGrid* grid, int interval, int slab)
{
  std::vector<WeightedTetrahedron> tetrahedra;
  if (grid->GetNumberOfCells() == 0)
  {
    return tetrahedra;
  }
  vtkDataArray* durations = GetArray(grid->GetPointData(), "DeltaT");
  vtkDataArray* classes = GetArray(grid->GetCellData(), "SimplexClass");
  ForEachSimplex<4>(grid, interval, "TimeSlab", slab,
    [&](vtkIdType cell, const Tetrahedron& points)
    {
      WeightedTetrahedron tetrahedron = { points, 0, -1, 0,
        static_cast<int>(classes->GetComponent(cell, 0)) };
      Real duration = 0;
      for (vtkIdType point : points)
      {
        const double here = durations->GetComponent(point, 0);
        duration += here;
        if (here != 0)
        {
          ++tetrahedron.ThickPoints;
          tetrahedron.Thick = point;
        }
      }
      tetrahedron.Hypervolume = DeterminantOf(CornersOf(grid, points)) / 24 * duration;
      tetrahedra.push_back(tetrahedron);
    });
  return tetrahedra;
}

std::vector<std::vector<WeightedTetrahedron>> GroupByThickPoint(
  const std::vector<WeightedTetrahedron>& tetrahedra)
{
  std::vector<std::vector<WeightedTetrahedron>> groups;
  for (const WeightedTetrahedron& tetrahedron : tetrahedra)
  {
    if (groups.empty() || groups.back().back().Thick != tetrahedron.Thick)
    {
      groups.emplace_back();
    }
    groups.back().push_back(tetrahedron);
  }
  return groups;
}

long double DurationAt(
  vtkUnstructuredGrid* tetrahedra, const std::array<double, 3>& point, int interval)
{
  const std::array<Real, 3> x = { point[0], point[1], point[2] };
  vtkDataArray* durations = GetArray(tetrahedra->GetPointData(), "DeltaT");
  Real sum = 0;
  ForEachSimplex<4>(tetrahedra, interval, "TimeSlab", Any,
    [&](vtkIdType, const Tetrahedron& points)
    {
      const auto corners = CornersOf(tetrahedra, points);
      const Real volume = DeterminantOf(corners);
      Real duration = 0;
      for (int i = 0; i < 4; ++i)
      {
        auto replaced = corners;
        replaced[i] = x;
        const Real weight = DeterminantOf(replaced) / volume;
        // A degenerate tetrahedron has NaN or infinite weights, and is treated as containing no
        // point.
        if (!(weight >= 0))
        {
          return;
        }
        duration += weight * durations->GetComponent(points[i], 0);
      }
      sum += volume > 0 ? duration : -duration;
    });
  return sum;
}

}

// SPDX-License-Identifier: BSD-3-Clause
// The boundaries at the first and last step equal the interval volume of that step and its
// surfaces. Each kind of boundary is generated only if requested.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceVolume.h"
#include "Support/TimeVarying/ReferenceSimplices.h"
#include "Support/TimeVarying/ReferenceTemporal.h"
#include "Support/TimeVarying/ReferenceTimeVarying.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <set>

namespace
{

using namespace reference;

using Filter = vtkTimeVaryingIntervalVolume;
using Position = std::array<double, 3>;

const std::vector<Interval> Intervals = { { 0.2, 0.45 }, { 0.45, 0.8 } };

Position PositionOf(vtkUnstructuredGrid* grid, vtkIdType id)
{
  Position x;
  grid->GetPoint(id, x.data());
  return x;
}

/// Returns the set of point positions of each cell.
template <size_t N>
std::multiset<std::set<Position>> PositionsOf(
  vtkUnstructuredGrid* grid, const std::vector<std::array<vtkIdType, N>>& cells)
{
  std::multiset<std::set<Position>> positions;
  for (const auto& cell : cells)
  {
    std::set<Position> corners;
    for (vtkIdType id : cell)
    {
      corners.insert(PositionOf(grid, id));
    }
    positions.insert(corners);
  }
  return positions;
}

template <size_t N>
std::set<Position> PointsOf(
  vtkUnstructuredGrid* grid, const std::vector<std::array<vtkIdType, N>>& cells)
{
  std::set<Position> points;
  for (const auto& corners : PositionsOf(grid, cells))
  {
    points.insert(corners.begin(), corners.end());
  }
  return points;
}

/// Returns the vector area of triangles. It depends only on the boundary edges of a surface, not on
/// its triangulation.
std::array<double, 3> AreaOf(vtkUnstructuredGrid* grid, const std::vector<Triangle>& triangles)
{
  std::array<double, 3> area{};
  for (const Triangle& t : triangles)
  {
    const Position a = PositionOf(grid, t[0]);
    const Position b = PositionOf(grid, t[1]);
    const Position c = PositionOf(grid, t[2]);
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      area[i] += ((b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j])) / 2;
    }
  }
  return area;
}

double VolumeOf(vtkUnstructuredGrid* grid, const std::vector<Tetrahedron>& tetrahedra)
{
  long double volume = 0;
  for (const Tetrahedron& t : tetrahedra)
  {
    std::array<std::array<long double, 3>, 4> x;
    for (int i = 0; i < 4; ++i)
    {
      const Position position = PositionOf(grid, t[i]);
      x[i] = { position[0], position[1], position[2] };
    }
    volume += Determinant(x[0], x[1], x[2], x[3]) / 6;
  }
  return static_cast<double>(volume);
}

void CheckEnd(const TimeSteps& steps, const TimeVaryingExtraction& found, int end, Check& check)
{
  vtkDataSet* data = GetDataSet(end == 0 ? steps.front() : steps.back());
  const Extraction expected = ExtractIntervals(data, Intervals);
  for (int i = 0; i < static_cast<int>(Intervals.size()); ++i)
  {
    const std::string name =
      (end == 0 ? "start, interval " : "end, interval ") + std::to_string(i) + ": ";
    const auto volume = BoundaryCellsOf<4>(found.Boundaries, i, Filter::VOLUME_AT_START + end);
    const auto tetrahedra = TetrahedraOf(expected.Volume, i);
    check.That(!tetrahedra.empty(), name + "there are tetrahedra");
    check.That(PositionsOf(found.Boundaries, volume) == PositionsOf(expected.Volume, tetrahedra),
      name + "the tetrahedra equal the output of vtkIntervalVolume");
    check.Near(VolumeOf(found.Boundaries, volume), VolumeOf(expected.Volume, tetrahedra), 1e-13,
      name + "signed volume");
    for (int side = 0; side < 2; ++side)
    {
      const auto surface =
        BoundaryCellsOf<3>(found.Boundaries, i, Filter::LOWER_SURFACE_AT_START + 2 * end + side);
      const auto triangles = BoundaryOf(expected.Surface, i, side);
      const std::string part = name + (side == 0 ? "lower" : "upper") + " surface: ";
      check.That(PointsOf(found.Boundaries, surface) == PointsOf(expected.Surface, triangles),
        part + "the points equal the output of vtkIntervalVolume");
      check.That(PositionsOf(found.Boundaries, surface) == PositionsOf(expected.Surface, triangles),
        part + "the triangles equal the output of vtkIntervalVolume");
      const auto area = AreaOf(found.Boundaries, surface);
      const auto known = AreaOf(expected.Surface, triangles);
      for (int a = 0; a < 3; ++a)
      {
        check.Near(area[a], known[a], 1e-12, part + "area", 1);
      }
    }
  }
}

/// Generates each kind of boundary separately and compares it with its part of the output for all
/// kinds.
void CheckKinds(const TimeSteps& steps, const TimeVaryingExtraction& all, Check& check)
{
  for (int kind = 0; kind < Filter::NUMBER_OF_BOUNDARY_KINDS; ++kind)
  {
    TimeVaryingSettings settings = { Intervals };
    settings.Boundaries = settings.Tetrahedra = settings.Simplices = false;
    vtkNew<TimeStepSource> source;
    source->SetSteps(steps);
    vtkNew<Filter> filter;
    filter->SetInputConnection(source->GetOutputPort());
    Apply(settings, filter);
    filter->SetGenerateBoundary(kind, true);
    filter->Update();
    const std::string name = "kind " + std::to_string(kind) + " only: ";
    auto* boundary = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(1));
    long long cells = 0;
    for (int i = 0; i < static_cast<int>(Intervals.size()); ++i)
    {
      if (kind < Filter::LOWER_SURFACE_IN_TIME)
      {
        const auto triangles = BoundaryCellsOf<3>(boundary, i, kind);
        cells += static_cast<long long>(triangles.size());
        check.That(PositionsOf(boundary, triangles) ==
            PositionsOf(all.Boundaries, BoundaryCellsOf<3>(all.Boundaries, i, kind)),
          name + "the triangles equal the triangles of all kinds");
      }
      else
      {
        const auto tetrahedra = BoundaryCellsOf<4>(boundary, i, kind);
        cells += static_cast<long long>(tetrahedra.size());
        check.That(PositionsOf(boundary, tetrahedra) ==
            PositionsOf(all.Boundaries, BoundaryCellsOf<4>(all.Boundaries, i, kind)),
          name + "the tetrahedra equal the tetrahedra of all kinds");
      }
    }
    check.That(cells > 0, name + "there are cells");
    check.Equal(boundary->GetNumberOfCells(), cells, name + "no cells of other kinds");
    check.Equal(filter->GetReport()->GetCount("Boundaries", kind), cells, name + "reported");
    for (int port : { 0, 2 })
    {
      auto* other = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(port));
      check.Equal(other->GetNumberOfCells(), 0, name + "cells of port " + std::to_string(port));
    }
  }
}

}

int TestTimeVaryingBoundaries(int, char*[])
{
  Check check;
  for (const NamedGrid& grid : MakeAllGridTypes({ 3, 2, 2 }, 4))
  {
    TimeSteps steps = RepeatGrid(grid.Data, { 1, 1.5, 4 });
    AddRandomTimeField(steps, 6);
    check.SetContext(grid.Name + ", static");
    const TimeVaryingExtraction found = ExtractTimeVarying(steps, { Intervals });
    CheckEnd(steps, found, 0, check);
    CheckEnd(steps, found, 1, check);
    CheckKinds(steps, found, check);
    if (vtkPointSet::SafeDownCast(grid.Data))
    {
      check.SetContext(grid.Name + ", stretched");
      MovePoints(steps, Stretch);
      const TimeVaryingExtraction moved = ExtractTimeVarying(steps, { Intervals });
      CheckEnd(steps, moved, 0, check);
      CheckEnd(steps, moved, 1, check);
    }
    // The boundaries in time are at the first and last step of the range.
    check.SetContext(grid.Name + ", the last two steps");
    TimeVaryingSettings settings = { Intervals };
    settings.Steps = { 1, 2 };
    const TimeVaryingExtraction late = ExtractTimeVarying(steps, settings);
    steps.erase(steps.begin());
    CheckEnd(steps, late, 0, check);
    CheckEnd(steps, late, 1, check);
  }
  return check.Result();
}

// SPDX-License-Identifier: BSD-3-Clause
// Slices of 4-simplices: a slice at a time step equals the interval volume of the step, even for
// values equal to bounds. Adjacent intervals tile the domain at steps, close to steps and between
// steps. Slices are exact for functions linear in space and time, and second order in the time step
// for a smooth function.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Meshes/ReferenceVolume.h"
#include "Support/TimeVarying/ReferenceSimplexGrid.h"
#include "Support/TimeVarying/ReferenceTimeVarying.h"

#include "vtkDataSet.h"
#include "vtkPointSet.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{

using namespace reference;

const std::vector<Interval> Intervals = { { 0.2, 0.45 }, { 0.45, 0.8 } };
const std::vector<double> Times = { 1, 1.5, 4 };

vtkSmartPointer<vtkUnstructuredGrid> SimplicesOf(
  const TimeSteps& steps, const std::vector<Interval>& intervals)
{
  TimeVaryingSettings settings = { intervals };
  settings.Tetrahedra = settings.Boundaries = false;
  return ExtractTimeVarying(steps, settings).Simplices;
}

void CheckSteps(const TimeSteps& steps, Check& check)
{
  const auto simplices = SimplicesOf(steps, Intervals);
  for (const TimeStep& step : steps)
  {
    const auto expected =
      GeometricSet(ExtractIntervals(GetDataSet(step), Intervals).Volume, { "IntervalId" });
    check.That(!expected.empty(), "there are tetrahedra");
    check.That(GeometricSet(SliceAt(simplices, step.Time), { "IntervalId" }) == expected,
      "the tetrahedra equal the output of vtkIntervalVolume at time " + std::to_string(step.Time));
  }
}

/// For values equal to interval bounds, checks that the volume of the slice at each step equals the
/// volume that vtkIntervalVolume extracts.
void CheckTies(const TimeSteps& steps, const std::vector<Interval>& intervals, Check& check)
{
  const auto simplices = SimplicesOf(steps, intervals);
  for (const TimeStep& step : steps)
  {
    const Extraction expected = ExtractIntervals(GetDataSet(step), intervals);
    const auto slice = SliceAt(simplices, step.Time);
    for (int i = 0; i < static_cast<int>(intervals.size()); ++i)
    {
      check.Near(static_cast<double>(MeasureInterval(slice, i).Sum),
        static_cast<double>(MeasureInterval(expected.Volume, i).Sum), 1e-12,
        "volume of interval " + std::to_string(i) + " at time " + std::to_string(step.Time), 1);
    }
  }
}

/// Intervals that cover all values tile the domain at any time.
void CheckTiling(const TimeSteps& steps, const std::vector<Interval>& intervals, Check& check)
{
  const auto simplices = SimplicesOf(steps, intervals);
  const double domain = static_cast<double>(MeshVolume(GetDataSet(steps.front())));
  for (const double time : { 1.0, 1.000001, 1.25, 1.499999, 1.5, 1.500001, 3.999999, 4.0 })
  {
    check.Near(static_cast<double>(MeasureTetrahedra(SliceAt(simplices, time)).Sum) / domain, 1,
      1e-12, "sum of the volumes relative to the domain at time " + std::to_string(time));
  }
}

/// Compares the volumes of slices at several times with the expected volumes of the intervals.
/// \a at returns the time steps at the given times.
template <typename At>
void CheckBetween(const std::vector<Interval>& intervals, At&& at, Check& check)
{
  const auto simplices = SimplicesOf(at(Times), intervals);
  for (double time : { 1.0625, 1.25, 1.4375, 2.0, 3.9 })
  {
    const TimeSteps there = at({ time });
    const auto slice = SliceAt(simplices, time);
    for (int i = 0; i < static_cast<int>(intervals.size()); ++i)
    {
      const double expected = static_cast<double>(
        ClippedVolume(GetDataSet(there.front()), { { "f", intervals[i][0], intervals[i][1] } }));
      check.Near(static_cast<double>(MeasureInterval(slice, i).Sum), expected, 1e-12,
        "volume of interval " + std::to_string(i) + " at time " + std::to_string(time),
        static_cast<double>(MeshVolume(GetDataSet(there.front()))));
    }
  }
}

double Linear(const std::array<double, 3>& x, double time, vtkIdType)
{
  return 0.3 + 0.7 * x[0] - 0.4 * x[1] + 0.9 * x[2] + 0.8 * time;
}

void CheckGrid(const NamedGrid& grid, Check& check)
{
  const bool canMove = vtkPointSet::SafeDownCast(grid.Data) && HasBoxDomain(grid.Data);
  check.SetContext(grid.Name + ", at steps");
  TimeSteps steps = RepeatGrid(grid.Data, Times);
  AddRandomTimeField(steps, 6);
  CheckSteps(steps, check);
  for (const int values : { 2, 3 })
  {
    check.SetContext(grid.Name + ", " + std::to_string(values) + " values");
    AddIntegerTimeField(steps, values, 2);
    CheckTies(steps, { { 0, 1 }, { 1, 1.5 }, { 1.5, 2 } }, check);
    CheckTies(steps, { { 0, 1 }, { 0.5, 1 }, { 1.5, 2 } }, check);
    CheckTiling(steps, { { 0, 1 }, { 1, 2 } }, check);
  }
  if (canMove)
  {
    check.SetContext(grid.Name + ", moving, at steps");
    AddRandomTimeField(steps, 7);
    MovePoints(steps, Stretch);
    CheckSteps(steps, check);
  }
  check.SetContext(grid.Name + ", linear");
  const double* center = grid.Data->GetCenter();
  const double midpoint = Linear({ center[0], center[1], center[2] }, 1.4, 0);
  const std::vector<Interval> around = { { midpoint - 1.1, midpoint - 0.2 },
    { midpoint - 0.2, midpoint + 1.3 } };
  CheckBetween(
    around,
    [&](const std::vector<double>& times)
    {
      const TimeSteps linear = RepeatGrid(grid.Data, times);
      AddSpaceTimeField(linear, Linear);
      return linear;
    },
    check);
  if (canMove)
  {
    check.SetContext(grid.Name + ", moving, linear");
    CheckBetween(
      around,
      [&](const std::vector<double>& times)
      {
        const TimeSteps linear = RepeatGrid(grid.Data, times);
        MovePoints(linear, Stretch);
        AddSpaceTimeField(linear, Linear);
        return linear;
      },
      check);
  }
  if (IsTetrahedral(grid.Data))
  {
    check.SetContext(grid.Name + ", multilinear");
    CheckBetween(
      { { 0.7, 1.3 }, { 1.3, 1.9 } },
      [&](const std::vector<double>& times)
      {
        const TimeSteps drifting = RepeatGrid(grid.Data, times);
        AddDriftingField(drifting, 0.6, 4);
        return drifting;
      },
      check);
  }
}

/// Slices a moving spherical shell of varying size between two steps. The error of its volume
/// decreases about quadratically with the time step.
void CheckOrder(Check& check)
{
  const auto mesh = MakeMesh(MeshKind::Tetrahedra6, { 8, 8, 8 });
  const auto ball = [](const std::array<double, 3>& x, double time, vtkIdType)
  {
    const double angle = 2 * time;
    return std::hypot(x[0] - 4 - std::cos(angle), x[1] - 4 - std::sin(angle), x[2] - 4) -
      0.5 * std::sin(3 * time);
  };
  const std::vector<Interval> shell = { { 1.1, 2.3 } };
  const auto at = [&](const std::vector<double>& times)
  {
    const TimeSteps steps = RepeatGrid(mesh, times);
    AddSpaceTimeField(steps, ball);
    return steps;
  };
  const auto volume = [&](vtkUnstructuredGrid* grid)
  { return static_cast<double>(MeasureInterval(grid, 0).Sum); };
  std::vector<double> errors;
  for (double step : { 0.4, 0.2, 0.1, 0.05 })
  {
    // Mean relative error at the midpoints of four slabs.
    double error = 0;
    for (double midpoint : { 0.3, 0.55, 0.8, 1.05 })
    {
      const auto slice =
        SliceAt(SimplicesOf(at({ midpoint - step / 2, midpoint + step / 2 }), shell), midpoint);
      const double known =
        volume(ExtractIntervals(GetDataSet(at({ midpoint }).front()), shell).Volume);
      error += std::abs(volume(slice) - known) / known / 4;
    }
    errors.push_back(error);
    std::cout << "step " << step << ": error of the volume of a slice " << error << '\n';
  }
  check.SetContext("order");
  for (size_t i = 1; i < errors.size(); ++i)
  {
    check.That(errors[i] < errors[i - 1] / 2.8,
      "half the step, about a quarter of the error: " + std::to_string(errors[i - 1]) + " to " +
        std::to_string(errors[i]));
  }
}

}

int TestTimeVaryingSlice(int, char*[])
{
  Check check;
  for (const NamedGrid& grid : MakeAllGridTypes({ 3, 2, 2 }, 4))
  {
    CheckGrid(grid, check);
  }
  CheckOrder(check);
  return check.Result();
}

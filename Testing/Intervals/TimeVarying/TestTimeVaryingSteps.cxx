// SPDX-License-Identifier: BSD-3-Clause
// Time steps through the pipeline: two are alive at most, each is asked for once, slabs one by one
// are those of all together, and changes of the steps are seen.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/TimeVarying/ReferenceSimplices.h"
#include "Support/TimeVarying/ReferenceTemporal.h"
#include "Support/TimeVarying/ReferenceTimeVarying.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkTestErrorObserver.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace
{

using namespace reference;

const std::vector<Interval> Intervals = { { 0.2, 0.45 }, { 0.45, 0.8 } };
const std::vector<double> Times = { 0, 0.5, 2, 2.25, 3 };

/// What an output is made of, with the slab that a part begins with added.
std::vector<GeometricSimplex> SetOf(
  vtkUnstructuredGrid* grid, const char* kind, const char* fourth, int firstSlab)
{
  std::vector<GeometricSimplex> set =
    GeometricSet(grid, { "IntervalId", kind, "TimeSlab" }, fourth);
  for (GeometricSimplex& simplex : set)
  {
    simplex.back() += firstSlab;
  }
  return set;
}

/// Takes the tetrahedra at steps out of what port 2 is made of; two slabs may have the same.
std::set<GeometricSimplex> TakeOutAtSteps(std::vector<GeometricSimplex>& set)
{
  std::set<GeometricSimplex> atSteps;
  const auto end = std::remove_if(set.begin(), set.end(),
    [&atSteps](const GeometricSimplex& simplex)
    {
      const bool isAtStep =
        simplex[simplex.size() - 2] == vtkTimeVaryingIntervalVolume::TETRAHEDRON_AT_STEP;
      if (isAtStep)
      {
        atSteps.emplace(simplex.begin(), simplex.end() - 1);
      }
      return isAtStep;
    });
  set.erase(end, set.end());
  return atSteps;
}

void CheckSlabs(const SpaceTimeGrid& grid, bool integers, Check& check)
{
  const TimeSteps steps = RepeatGrid(grid.Data, Times);
  integers ? AddIntegerTimeField(steps, 3, 8) : AddRandomTimeField(steps, 8);
  if (vtkPointSet::SafeDownCast(grid.Data))
  {
    MovePoints(steps, Stretch);
  }
  TimeVaryingSettings settings = { integers ? std::vector<Interval>{ { 0, 1 }, { 1, 1.5 } }
                                            : Intervals };
  const TimeVaryingExtraction all = ExtractTimeVarying(steps, settings);
  std::vector<GeometricSimplex> tetrahedra;
  std::vector<GeometricSimplex> simplices;
  const int slabs = static_cast<int>(Times.size()) - 1;
  for (int slab = 0; slab < slabs; ++slab)
  {
    settings.Steps = { slab, slab + 1 };
    const TimeVaryingExtraction one = ExtractTimeVarying(steps, settings);
    check.Near(one.Report->GetNumber("TimeSteps"), 2, 0.0, "time steps reported of a slab");
    for (const GeometricSimplex& simplex : SetOf(one.Tetrahedra, "SimplexClass", "DeltaT", slab))
    {
      tetrahedra.push_back(simplex);
    }
    for (const GeometricSimplex& simplex : SetOf(one.Simplices, "AtStep", "Time", slab))
    {
      simplices.push_back(simplex);
    }
  }
  std::vector<GeometricSimplex> together = SetOf(all.Simplices, "AtStep", "Time", 0);
  const auto atSteps = TakeOutAtSteps(simplices);
  check.That(TakeOutAtSteps(together) == atSteps, "tetrahedra at steps of slabs one by one");
  check.That(atSteps.empty() == !integers, "tetrahedra at steps where values equal bounds");
  std::sort(tetrahedra.begin(), tetrahedra.end());
  std::sort(simplices.begin(), simplices.end());
  check.That(!simplices.empty(), "there are 4-simplices");
  check.That(SetOf(all.Tetrahedra, "SimplexClass", "DeltaT", 0) == tetrahedra,
    "tetrahedra of slabs one by one");
  check.That(together == simplices, "4-simplices of slabs one by one");
  check.Near(all.Report->GetNumber("TimeSteps"), slabs + 1, 0.0, "time steps reported");
  check.Near(all.Report->GetNumber("Slabs"), slabs, 0.0, "slabs reported");
  // Points at the steps between are shared: no two have the same place and time.
  if (!integers)
  {
    std::set<std::array<double, 4>> places;
    vtkDataArray* times = all.Simplices->GetPointData()->GetArray("Time");
    for (vtkIdType i = 0; i < all.Simplices->GetNumberOfPoints(); ++i)
    {
      std::array<double, 4> place;
      all.Simplices->GetPoint(i, place.data());
      place[3] = times->GetComponent(i, 0);
      places.insert(place);
    }
    check.Equal(static_cast<long long>(places.size()), all.Simplices->GetNumberOfPoints(),
      "points in a place of their own");
  }
}

struct Pipeline : TimeVaryingPipeline
{
  explicit Pipeline(const TimeSteps& steps)
    : TimeVaryingPipeline(steps, { Intervals })
  {
  }

  vtkUnstructuredGrid* GetSimplices()
  {
    return vtkUnstructuredGrid::SafeDownCast(this->Filter->GetOutputDataObject(2));
  }
};

TimeSteps MakeSteps(const std::vector<double>& times)
{
  const TimeSteps steps = RepeatGrid(MakeMesh(MeshKind::Mixed, { 2, 2, 2 }), times);
  AddRandomTimeField(steps, 3);
  return steps;
}

void CheckRequests(Check& check)
{
  check.SetContext("requests");
  Pipeline pipeline(MakeSteps(Times));
  pipeline.Filter->Update();
  std::vector<int> expected(Times.size());
  std::iota(expected.begin(), expected.end(), 0);
  check.That(pipeline.Source->GetRequests() == expected, "every step is asked for once, in order");
  check.That(pipeline.Source->GetMostAlive() <= 2,
    "two steps are alive at most, not " + std::to_string(pipeline.Source->GetMostAlive()));
  const vtkIdType cells = pipeline.GetSimplices()->GetNumberOfCells();
  check.That(cells > 0, "there is output");

  pipeline.Source->ClearRequests();
  pipeline.Filter->Update();
  check.That(pipeline.Source->GetRequests().empty(), "no step is asked for when nothing changed");

  pipeline.Filter->SetTimeStepRange(1, 3);
  pipeline.Filter->Update();
  check.That(pipeline.Source->GetRequests() == std::vector<int>({ 1, 2, 3 }),
    "only the steps of the range are asked for");
  check.Near(pipeline.Filter->GetReport()->GetNumber("TimeSteps"), 3, 0.0,
    "time steps of the range reported");
  check.That(pipeline.GetSimplices()->GetNumberOfCells() < cells, "fewer 4-simplices");

  // A last step beyond the input's is its last.
  pipeline.Filter->SetTimeStepRange(0, 1000);
  pipeline.Filter->Update();
  check.Equal(pipeline.GetSimplices()->GetNumberOfCells(), cells, "all 4-simplices again");
}

void CheckChanges(Check& check)
{
  check.SetContext("changes");
  Pipeline pipeline(MakeSteps({ 0, 1, 2 }));
  pipeline.Filter->Update();
  for (const std::vector<double>& times :
    { std::vector<double>{ 0, 1, 2, 3, 4 }, { 5, 7 }, { 0, 1, 2 } })
  {
    const TimeSteps steps = MakeSteps(times);
    pipeline.Source->SetSteps(steps);
    pipeline.Filter->Update();
    const TimeVaryingExtraction expected = ExtractTimeVarying(steps, { Intervals });
    const std::string difference = FindDifference(pipeline.GetSimplices(), expected.Simplices);
    check.That(difference.empty(), "steps changed: " + difference);
  }
  pipeline.Filter->SetInterval(1, 0.5, 0.9);
  pipeline.Filter->Update();
  TimeVaryingSettings settings = { { Intervals[0], { 0.5, 0.9 } } };
  const std::string difference = FindDifference(
    pipeline.GetSimplices(), ExtractTimeVarying(MakeSteps({ 0, 1, 2 }), settings).Simplices);
  check.That(difference.empty(), "interval changed: " + difference);
}

/// Slabs of no duration are left out with a warning, those on either side of them stay.
void CheckEqualTimes(Check& check)
{
  check.SetContext("equal times");
  Pipeline pipeline(MakeSteps({ 0, 1, 1, 2 }));
  vtkNew<vtkTest::ErrorObserver> observer;
  pipeline.Filter->AddObserver(vtkCommand::WarningEvent, observer);
  pipeline.Filter->AddObserver(vtkCommand::ErrorEvent, observer);
  pipeline.Filter->Update();
  check.That(observer->GetWarning(), "there is a warning");
  check.That(!observer->GetError(), "there is no error: " + observer->GetErrorMessage());
  check.Near(
    pipeline.Filter->GetReport()->GetNumber("Slabs"), 2, 0.0, "slabs that are not left out");
  check.That(pipeline.GetSimplices()->GetNumberOfCells() > 0, "there is output");
  std::set<int> slabs;
  vtkDataArray* numbers = pipeline.GetSimplices()->GetCellData()->GetArray("TimeSlab");
  for (vtkIdType i = 0; i < numbers->GetNumberOfTuples(); ++i)
  {
    slabs.insert(static_cast<int>(numbers->GetComponent(i, 0)));
  }
  check.That(slabs == std::set<int>({ 0, 2 }), "slabs are numbered by their first step");
}

/// Outputs that are not asked for are empty and cost nothing.
void CheckPayForUse(Check& check)
{
  check.SetContext("pay for use");
  const TimeSteps steps = MakeSteps({ 0, 1, 2 });
  vtkNew<vtkTimeVaryingIntervalVolume> defaults;
  check.That(defaults->GetGenerateTetrahedra() && !defaults->GetGenerateSimplices(),
    "tetrahedra only by default");
  for (int kind = 0; kind < vtkTimeVaryingIntervalVolume::NUMBER_OF_BOUNDARY_KINDS; ++kind)
  {
    check.That(!defaults->GetGenerateBoundary(kind), "no boundary by default");
  }
  check.That(
    !defaults->GetGenerateBoundary(-1) && !defaults->GetGenerateBoundary(8), "kinds that are none");
  TimeVaryingSettings settings = { Intervals };
  const TimeVaryingExtraction all = ExtractTimeVarying(steps, settings);
  for (int port = 0; port < 3; ++port)
  {
    settings.Tetrahedra = port == 0;
    settings.Boundaries = port == 1;
    settings.Simplices = port == 2;
    const TimeVaryingExtraction one = ExtractTimeVarying(steps, settings);
    vtkUnstructuredGrid* const found[] = { one.Tetrahedra, one.Boundaries, one.Simplices };
    vtkUnstructuredGrid* const expected[] = { all.Tetrahedra, all.Boundaries, all.Simplices };
    for (int other = 0; other < 3; ++other)
    {
      const std::string name =
        "port " + std::to_string(other) + " with port " + std::to_string(port) + " on: ";
      if (other != port)
      {
        check.Equal(found[other]->GetNumberOfCells(), 0, name + "cells");
        check.Equal(found[other]->GetNumberOfPoints(), 0, name + "points");
        continue;
      }
      const std::string difference = FindDifference(found[port], expected[port]);
      check.That(difference.empty(), name + difference);
    }
    const auto sum = [&one](const char* name)
    {
      double total = 0.0;
      for (vtkIdType i = 0; i < one.Report->GetSize(name); ++i)
      {
        total += one.Report->GetNumber(name, i);
      }
      return total;
    };
    check.That((sum("Tetrahedra") > 0) == (port == 0), "tetrahedra reported");
    check.That((sum("Boundaries") > 0) == (port == 1), "boundaries reported");
    check.That(one.Report->GetNumber("WorkingBytes") <= all.Report->GetNumber("WorkingBytes"),
      "no more bytes than for all");
  }
  check.That(all.Report->GetNumber("TableLookups") > 0, "lookups in tables reported");
}

}

int TestTimeVaryingSteps(int, char*[])
{
  Check check;
  for (const SpaceTimeGrid& grid : AllSpaceTimeGrids({ 2, 2, 2 }, 5))
  {
    for (bool integers : { false, true })
    {
      check.SetContext(grid.Name + (integers ? ", integers" : ", random values"));
      CheckSlabs(grid, integers, check);
    }
  }
  CheckRequests(check);
  CheckChanges(check);
  CheckEqualTimes(check);
  CheckPayForUse(check);
  return check.Result();
}

// SPDX-License-Identifier: BSD-3-Clause
// Time steps through the pipeline: at most two exist at a time, each is requested once, single
// slabs equal the slabs of the full range, and modified steps are detected.
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

/// Returns the sorted simplices of an output. Adds \a firstSlab to their TimeSlab values.
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

/// Removes the tetrahedra at time steps from the simplices of port 2 and returns them without
/// duplicates. Two slabs may have the same tetrahedron.
std::set<GeometricSimplex> RemoveAtSteps(std::vector<GeometricSimplex>& set)
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

void CheckSlabs(const NamedGrid& grid, bool integers, Check& check)
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
    check.Equal(one.Report->GetCount("TimeSteps"), 2, "time steps reported for a slab");
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
  const auto atSteps = RemoveAtSteps(simplices);
  check.That(RemoveAtSteps(together) == atSteps, "tetrahedra at steps of single slabs");
  check.That(atSteps.empty() == !integers, "tetrahedra at steps where values equal bounds");
  std::sort(tetrahedra.begin(), tetrahedra.end());
  std::sort(simplices.begin(), simplices.end());
  check.That(!simplices.empty(), "there are 4-simplices");
  check.That(
    SetOf(all.Tetrahedra, "SimplexClass", "DeltaT", 0) == tetrahedra, "tetrahedra of single slabs");
  check.That(together == simplices, "4-simplices of single slabs");
  check.Equal(all.Report->GetCount("TimeSteps"), slabs + 1, "time steps reported");
  check.Equal(all.Report->GetCount("Slabs"), slabs, "slabs reported");
  // Slabs share the points at inner steps, so no two points have the same position and time.
  if (!integers)
  {
    std::set<std::array<double, 4>> positions;
    vtkDataArray* times = all.Simplices->GetPointData()->GetArray("Time");
    for (vtkIdType i = 0; i < all.Simplices->GetNumberOfPoints(); ++i)
    {
      std::array<double, 4> position;
      all.Simplices->GetPoint(i, position.data());
      position[3] = times->GetComponent(i, 0);
      positions.insert(position);
    }
    check.Equal(static_cast<long long>(positions.size()), all.Simplices->GetNumberOfPoints(),
      "points with distinct positions and times");
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
  check.That(pipeline.Source->GetRequests() == expected, "every step is requested once, in order");
  check.That(pipeline.Source->GetMaximumStepsInMemory() <= 2,
    "at most two steps exist at a time: " +
      std::to_string(pipeline.Source->GetMaximumStepsInMemory()));
  const vtkIdType cells = pipeline.GetSimplices()->GetNumberOfCells();
  check.That(cells > 0, "the output is not empty");

  pipeline.Source->ClearRequests();
  pipeline.Filter->Update();
  check.That(pipeline.Source->GetRequests().empty(), "no step is requested if nothing changed");

  pipeline.Filter->SetTimeStepRange(1, 3);
  pipeline.Filter->Update();
  check.That(pipeline.Source->GetRequests() == std::vector<int>({ 1, 2, 3 }),
    "only steps of the range are requested");
  check.Equal(
    pipeline.Filter->GetReport()->GetCount("TimeSteps"), 3, "time steps reported for the range");
  check.That(pipeline.GetSimplices()->GetNumberOfCells() < cells, "fewer 4-simplices for a range");

  // A range that extends past the input's last step is clamped.
  pipeline.Filter->SetTimeStepRange(0, 1000);
  pipeline.Filter->Update();
  check.Equal(
    pipeline.GetSimplices()->GetNumberOfCells(), cells, "all 4-simplices for the full range");
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

/// Slabs with zero duration are skipped with a warning. The adjacent slabs are not affected.
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
  check.Equal(pipeline.Filter->GetReport()->GetCount("Slabs"), 2, "slabs used");
  check.That(pipeline.GetSimplices()->GetNumberOfCells() > 0, "the output is not empty");
  std::set<int> slabs;
  vtkDataArray* numbers = pipeline.GetSimplices()->GetCellData()->GetArray("TimeSlab");
  for (vtkIdType i = 0; i < numbers->GetNumberOfTuples(); ++i)
  {
    slabs.insert(static_cast<int>(numbers->GetComponent(i, 0)));
  }
  check.That(slabs == std::set<int>({ 0, 2 }), "slabs are numbered by their first step");
}

/// Outputs that are not requested are not computed and need no memory.
void CheckOutputsOnRequest(Check& check)
{
  check.SetContext("outputs on request");
  const TimeSteps steps = MakeSteps({ 0, 1, 2 });
  vtkNew<vtkTimeVaryingIntervalVolume> defaults;
  check.That(defaults->GetGenerateTetrahedra() && !defaults->GetGenerateSimplices(),
    "only tetrahedra by default");
  for (int kind = 0; kind < vtkTimeVaryingIntervalVolume::NUMBER_OF_BOUNDARY_KINDS; ++kind)
  {
    check.That(!defaults->GetGenerateBoundary(kind), "no boundaries by default");
  }
  check.That(!defaults->GetGenerateBoundary(-1) && !defaults->GetGenerateBoundary(8),
    "invalid kinds of boundaries are ignored");
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
      "memory does not exceed the memory for all outputs");
  }
  check.That(all.Report->GetNumber("TableLookups") > 0, "lookups in tables reported");
}

}

int TestTimeVaryingSteps(int, char*[])
{
  Check check;
  for (const NamedGrid& grid : MakeAllGridTypes({ 2, 2, 2 }, 5))
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
  CheckOutputsOnRequest(check);
  return check.Result();
}

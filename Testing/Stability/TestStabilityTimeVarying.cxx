// SPDX-License-Identifier: BSD-3-Clause
// Tests extreme times, large changes of values between steps, and grids that collapse or are far
// away.
#include "StabilityChecks.h"

#include "Support/Checks/ReferenceReport.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/TimeVarying/ReferenceSimplices.h"
#include "Support/TimeVarying/ReferenceSpaceTime.h"
#include "Support/TimeVarying/ReferenceTemporal.h"
#include "Support/TimeVarying/ReferenceTimeVarying.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace
{

using namespace reference;
using namespace stability;

constexpr std::array<int, 3> Cells = { 3, 2, 2 };
constexpr double DomainVolume = 3 * 2 * 2;
constexpr double Bound = 1e-12;
const std::vector<Interval> FullRange = { { 0, 0.3 }, { 0.3, 0.7 }, { 0.7, 1 } };

TimeSteps MakeSteps(const std::vector<double>& times, MeshKind kind = MeshKind::Mixed)
{
  const TimeSteps steps = RepeatGrid(MakeMesh(kind, Cells), times);
  AddRandomTimeField(steps, 3);
  return steps;
}

/// Outputs and messages of one run.
struct Outcome
{
  TimeVaryingExtraction Found;
  std::string Errors;
  std::string Warnings;

  bool IsEmpty() const
  {
    const auto isEmpty = [](vtkUnstructuredGrid* grid) { return grid->GetNumberOfCells() == 0; };
    return isEmpty(this->Found.Tetrahedra) && isEmpty(this->Found.Boundaries) &&
      isEmpty(this->Found.Simplices);
  }
};

Outcome Run(const TimeSteps& steps, const std::vector<Interval>& intervals)
{
  vtkNew<TimeStepSource> source;
  source->SetSteps(steps);
  vtkNew<vtkTimeVaryingIntervalVolume> filter;
  filter->SetInputConnection(source->GetOutputPort());
  Apply({ intervals }, filter);
  const Messages messages = UpdateFilter(filter);
  const auto output = [&](int port)
  { return vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(port)); };
  return { { output(0), output(1), output(2), CopyReport(filter->GetReport()) }, messages.Errors,
    messages.Warnings };
}

/// Returns the larger of the relative hypervolume errors of 4-simplices and tetrahedra, or NaN if
/// there is an error message.
double ErrorOf(const Outcome& outcome, double expected)
{
  if (!outcome.Errors.empty() || !(expected > 0))
  {
    return std::nan("");
  }
  const auto error = [&](const HypervolumeSum& sum)
  { return std::abs(static_cast<double>(sum.Sum) - expected) / expected; };
  return std::max(error(MeasureSimplices(outcome.Found.Simplices)),
    error(MeasureWeightedTetrahedra(outcome.Found.Tetrahedra)));
}

double DomainError(const TimeSteps& steps)
{
  return ErrorOf(Run(steps, FullRange), static_cast<double>(DomainHypervolume(steps)));
}

void TestTimes(StabilityCatalogue& catalogue)
{
  struct Case
  {
    const char* Name;
    const char* Extreme;
    std::vector<double> Times;
  };
  catalogue.Measure("equal-times-volume", "times 0, 1, 1, 3",
    "relative error of the domain's hypervolume",
    ErrorOf(Run(MakeSteps({ 0, 1, 1, 3 }), FullRange), 3 * DomainVolume), Bound);
  const Outcome all = Run(MakeSteps({ 1, 1 }), FullRange);
  catalogue.Check("all-times-equal", "times 1, 1", "a warning or an error and empty outputs",
    all.IsEmpty() ? "empty outputs" : "output",
    all.IsEmpty() && !(all.Warnings + all.Errors).empty());
  for (const Case& one : { Case{ "times-1e-9", "steps 1e-9 apart", { 0, 1e-9, 3e-9 } },
         { "times-1e+9", "steps 1e9 apart", { 0, 1e9, 3e9 } },
         { "times-1e-200", "steps 1e-200 apart", { 0, 1e-200, 3e-200 } },
         { "times-1e+200", "steps 1e200 apart", { 0, 1e200, 3e200 } },
         { "times-mixed", "steps 1e-9 and 1e9 apart", { -1e-9, 0, 1e9 } },
         { "times-offset", "steps 2^-10 apart from 2^30 on",
           { 1073741824, 1073741824 + 0x1p-10, 1073741824 + 0x1p-9 } } })
  {
    catalogue.Measure(one.Name, one.Extreme, "relative error of the domain's hypervolume",
      DomainError(MakeSteps(one.Times)), Bound);
  }
  // The 4-simplices of a long slab equal those of a short slab, stretched along time.
  const Outcome shorter = Run(MakeSteps({ 0, 1 }), { { 0.3, 0.7 } });
  for (double scale : { std::ldexp(1, -30), std::ldexp(1, 30) })
  {
    const Outcome scaled = Run(MakeSteps({ 0, scale }), { { 0.3, 0.7 } });
    catalogue.Measure(scale < 1 ? "same-cells-short" : "same-cells-long",
      "steps 2^-30 or 2^30 apart", "difference from the number of tetrahedra for steps 1 apart",
      static_cast<double>(
        scaled.Found.Tetrahedra->GetNumberOfCells() - shorter.Found.Tetrahedra->GetNumberOfCells()),
      0);
  }
}

void TestValues(StabilityCatalogue& catalogue)
{
  {
    const TimeSteps steps = MakeSteps({ 0, 1, 2 }, MeshKind::Hexahedra);
    vtkDataArray* values = GetDataSet(steps[1])->GetPointData()->GetScalars();
    // The point (1,1,1) of 4 x 3 x 3 points is used by eight cells in each of the two slabs.
    values->SetComponent(1 + 4 * (1 + 3 * 1), 0, std::nan(""));
    const Outcome outcome = Run(steps, FullRange);
    catalogue.Measure("nan-value", "NaN at one point at the middle step",
      "relative error of the hypervolume of the cells without it",
      ErrorOf(outcome, 2 * (DomainVolume - 8)), Bound);
    catalogue.Check("nan-value-count", "NaN at one point at the middle step",
      "8 cells skipped in each of two slabs",
      FormatShort(outcome.Found.Report->GetNumber("NonFiniteCells")) + " cells",
      outcome.Found.Report->GetNumber("NonFiniteCells") == 16);
  }
  {
    const TimeSteps steps = MakeSteps({ 0, 1, 2 });
    GetDataSet(steps[1])->GetPointData()->GetScalars()->Fill(std::nan(""));
    catalogue.Check("nan-step", "a step of NaN only", "empty outputs and no error",
      Run(steps, FullRange).IsEmpty() ? "empty outputs" : "output",
      Run(steps, FullRange).IsEmpty() && Run(steps, FullRange).Errors.empty());
  }
  const TimeSteps constant = MakeSteps({ 0, 1, 2 });
  AddSpaceTimeField(constant, [](const std::array<double, 3>&, double, vtkIdType) { return 3.0; });
  struct Case
  {
    const char* Name;
    std::vector<Interval> Intervals;
  };
  for (const Case& one :
    { Case{ "constant-lower", { { 3, 4 } } }, { "constant-upper", { { 2, 3 } } },
      { "constant-both", { { 3, 3 } } }, { "constant-shared", { { 2, 3 }, { 3, 4 } } } })
  {
    catalogue.Measure(one.Name, "every value at every step is a bound",
      "relative error of the domain's hypervolume",
      ErrorOf(Run(constant, one.Intervals), 2 * DomainVolume), Bound);
  }
  for (double jump : { 1e30, 1e300 })
  {
    const TimeSteps steps = MakeSteps({ 0, 1, 2 });
    AddSpaceTimeField(steps,
      [&](const std::array<double, 3>& x, double time, vtkIdType point)
      {
        const double value = 0.1 * x[0] + 0.01 * static_cast<double>(point % 7);
        return time == 1 ? jump * (0.25 + value) : value;
      });
    const std::vector<Interval> parts = { { -1, 0.15 }, { 0.15, jump / 3 }, { jump / 3, jump } };
    const std::string name = jump < 1e100 ? "jump-1e+30" : "jump-1e+300";
    catalogue.Measure(name, "values jump to 1e30 or 1e300 at the middle step",
      "relative error of the domain's hypervolume", ErrorOf(Run(steps, parts), 2 * DomainVolume),
      Bound);
  }
}

void TestGrids(StabilityCatalogue& catalogue)
{
  const auto measure = [&](
                         const char* name, const char* extreme, const Motion& motion, double bound)
  {
    for (MeshKind kind : { MeshKind::Tetrahedra5, MeshKind::Mixed })
    {
      const TimeSteps steps = MakeSteps({ 0, 1, 2 }, kind);
      MovePoints(steps, motion);
      catalogue.Measure(std::string(name) + "-" + GetName(kind), extreme,
        "relative error of the domain's hypervolume", DomainError(steps), bound);
    }
  };
  measure(
    "collapse-to-plane", "all cells are flat at the last step",
    [](std::array<double, 3>& x, double time) { x[0] *= 1 - 0.5 * time; }, Bound);
  measure(
    "collapse-layer", "a layer of cells is flat at the last step",
    [](std::array<double, 3>& x, double time)
    { x[0] = x[0] > 2 ? 2 + (x[0] - 2) * (1 - 0.5 * time) : x[0]; },
    Bound);
  measure(
    "collapse-to-point", "all points coincide at the last step",
    [](std::array<double, 3>& x, double time)
    {
      for (double& coordinate : x)
      {
        coordinate *= 1 - 0.5 * time;
      }
    },
    Bound);
  // A coordinate of 2^30 has 22 bits after the binary point, and the hypervolume is 24.
  measure(
    "far-away", "coordinates 2^30 from the origin",
    [](std::array<double, 3>& x, double)
    {
      for (double& coordinate : x)
      {
        coordinate += 1073741824;
      }
    },
    1e-6);
  measure(
    "small", "coordinates within 2^-30",
    [](std::array<double, 3>& x, double)
    {
      for (double& coordinate : x)
      {
        coordinate = std::ldexp(coordinate, -30);
      }
    },
    Bound);
  measure(
    "large", "coordinates to 2^30",
    [](std::array<double, 3>& x, double)
    {
      for (double& coordinate : x)
      {
        coordinate = std::ldexp(coordinate, 30);
      }
    },
    Bound);
  measure(
    "flat-cells", "cells a million times longer than thick",
    [](std::array<double, 3>& x, double) { x[2] *= 1e-6; }, Bound);
}

}

int TestStabilityTimeVarying(int argc, char* argv[])
{
  return RunCases(
    __func__, "vtkTimeVaryingIntervalVolume", argc, argv, { TestTimes, TestValues, TestGrids });
}

// SPDX-License-Identifier: BSD-3-Clause
// Functions linear in space and time: the hypervolume is exact on every grid, static and moving,
// for every direction of projection. On tetrahedra, this also holds for functions that are linear
// in space and in time separately.
#include "Support/Checks/LargestError.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/TimeVarying/ReferenceSimplices.h"
#include "Support/TimeVarying/ReferenceSpaceTime.h"
#include "Support/TimeVarying/ReferenceTimeVarying.h"

#include "vtkDataSet.h"
#include "vtkPointSet.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

namespace
{

using namespace reference;

constexpr double Tolerance = 1e-12;
const std::vector<double> Times = { -0.5, 0.25, 1.5 };
const std::vector<std::array<double, 4>> Directions = { { 0, 0, 0, 1 }, { 1, 1, 1, 1 },
  { 1, 0, 0, 0 }, { 0, 0, 0, -2.5 }, { 0.3, -1.7, 0.2, 0.9 }, { 0, 0, 1e-9, 1 } };

/// Divides the scalar range over all steps into four intervals and returns the two inner ones.
std::vector<Interval> IntervalsOf(const TimeSteps& steps)
{
  double range[2] = { 1e300, -1e300 };
  for (const TimeStep& step : steps)
  {
    double here[2];
    GetDataSet(step)->GetScalarRange(here);
    range[0] = std::min(range[0], here[0]);
    range[1] = std::max(range[1], here[1]);
  }
  const auto at = [&](double fraction) { return range[0] + fraction * (range[1] - range[0]); };
  return { { at(0.237), at(0.419) }, { at(0.419), at(0.731) } };
}

void CheckHypervolumes(const TimeSteps& steps, double& worst, Check& check)
{
  TimeVaryingSettings settings;
  settings.Intervals = IntervalsOf(steps);
  std::vector<double> expected;
  for (const Interval& interval : settings.Intervals)
  {
    expected.push_back(
      static_cast<double>(HypervolumeBetween(steps, "f", interval[0], interval[1])));
  }
  const double domain = static_cast<double>(DomainHypervolume(steps));
  for (const auto& direction : Directions)
  {
    settings.Direction = direction;
    const TimeVaryingExtraction found = ExtractTimeVarying(steps, settings);
    for (int i = 0; i < static_cast<int>(expected.size()); ++i)
    {
      const HypervolumeSum simplices = MeasureSimplices(found.Simplices, i);
      const HypervolumeSum weighted = MeasureWeightedTetrahedra(found.Tetrahedra, i);
      const std::string name = ", direction " + std::to_string(&direction - Directions.data()) +
        ", interval " + std::to_string(i);
      check.Near(
        static_cast<double>(simplices.Sum), expected[i], Tolerance, "4-simplices" + name, domain);
      check.Near(
        static_cast<double>(weighted.Sum), expected[i], Tolerance, "tetrahedra" + name, domain);
      reference::KeepLargest(
        worst, std::abs(static_cast<double>(weighted.Sum) - expected[i]) / domain);
    }
  }
}

}

int TestTimeVaryingLinear(int, char*[])
{
  Check check;
  const auto linear = [](const std::array<double, 3>& x, double time, vtkIdType)
  { return 0.3 + 0.7 * x[0] - 0.4 * x[1] + 0.9 * x[2] + 0.8 * time; };
  for (const NamedGrid& grid : MakeAllGridTypes({ 2, 3, 2 }, 3))
  {
    double worst = 0;
    check.SetContext(grid.Name + ", static");
    const TimeSteps standing = RepeatGrid(grid.Data, Times);
    AddSpaceTimeField(standing, linear);
    CheckHypervolumes(standing, worst, check);
    if (IsTetrahedral(grid.Data))
    {
      check.SetContext(grid.Name + ", multilinear");
      AddDriftingField(standing, 0.6, 2);
      CheckHypervolumes(standing, worst, check);
    }
    if (vtkPointSet::SafeDownCast(grid.Data) && HasBoxDomain(grid.Data))
    {
      check.SetContext(grid.Name + ", moving");
      const TimeSteps moving = RepeatGrid(grid.Data, Times);
      PerturbInteriorPoints(moving, 0.02 * grid.Data->GetLength(), 5);
      MovePoints(moving, Stretch);
      AddSpaceTimeField(moving, linear);
      CheckHypervolumes(moving, worst, check);
    }
    std::cout << grid.Name << ": error of the hypervolume " << worst << " of the domain\n";
  }
  return check.Result();
}

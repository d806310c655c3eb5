// SPDX-License-Identifier: BSD-3-Clause
// The sum of DeltaT over the tetrahedra that contain a point is the time during which the function
// at the point is in the interval.
#include "Support/Checks/LargestError.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/TimeVarying/ReferenceSimplices.h"
#include "Support/TimeVarying/ReferenceSpaceTime.h"
#include "Support/TimeVarying/ReferenceTimeVarying.h"

#include "vtkDataSet.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

namespace
{

using namespace reference;

constexpr int Samples = 40;
const std::vector<double> Times = { -0.5, 0.25, 1.5 };

/// Compares durations at random points near the center of the domain, where every grid has cells.
template <typename Known>
void CheckDurations(const TimeSteps& steps, const Interval& interval, Known&& known,
  const std::string& name, Check& check)
{
  check.SetContext(name);
  const TimeVaryingExtraction found = ExtractTimeVarying(steps, { { interval } });
  double box[6];
  GetDataSet(steps.front())->GetBounds(box);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> fraction(0.35, 0.65);
  double worst = 0;
  double longest = 0;
  for (int sample = 0; sample < Samples; ++sample)
  {
    std::array<double, 3> x;
    for (int a = 0; a < 3; ++a)
    {
      x[a] = box[2 * a] + fraction(random) * (box[2 * a + 1] - box[2 * a]);
    }
    const double expected = static_cast<double>(known(x));
    const double duration = static_cast<double>(DurationAt(found.Tetrahedra, x));
    check.Near(duration, expected, 1e-10, "duration at a point", 2);
    reference::KeepLargest(worst, std::abs(duration - expected));
    longest = std::max(longest, expected);
  }
  check.That(longest > 0, "the function is in the interval at some points");
  std::cout << name << ": largest error of a duration " << worst << '\n';
}

double Linear(const std::array<double, 3>& x, double time)
{
  return 0.3 + 0.7 * x[0] - 0.4 * x[1] + 0.9 * x[2] + 0.8 * time;
}

/// Returns how long the value of Linear() at a point lies in an interval.
double LinearDuration(const std::array<double, 3>& x, const Interval& interval)
{
  constexpr double rate = 0.8;
  const double from = (interval[0] - Linear(x, 0)) / rate;
  const double to = (interval[1] - Linear(x, 0)) / rate;
  return std::max(0.0, std::min(to, Times.back()) - std::max(from, Times.front()));
}

}

int TestTimeVaryingDurations(int, char*[])
{
  Check check;
  for (const NamedGrid& grid : MakeAllGridTypes({ 2, 2, 2 }, 2))
  {
    const TimeSteps steps = RepeatGrid(grid.Data, Times);
    AddSpaceTimeField(steps, [](const std::array<double, 3>&, double, vtkIdType) { return 0.5; });
    CheckDurations(
      steps, { 0, 1 }, [](const std::array<double, 3>&) { return 2.0; }, grid.Name + ", constant",
      check);
    AddSpaceTimeField(steps,
      [](const std::array<double, 3>& x, double time, vtkIdType) { return Linear(x, time); });
    const double* center = grid.Data->GetCenter();
    const double midpoint = Linear({ center[0], center[1], center[2] }, 0.4);
    const Interval around = { midpoint - 0.31, midpoint + 0.27 };
    CheckDurations(
      steps, around, [&](const std::array<double, 3>& x) { return LinearDuration(x, around); },
      grid.Name + ", linear", check);
    if (IsTetrahedral(grid.Data))
    {
      AddDriftingField(steps, 0.6, 3);
      CheckDurations(
        steps, { 0.4, 0.8 },
        [&](const std::array<double, 3>& x) { return DurationAt(steps, "f", 0.4, 0.8, x); },
        grid.Name + ", multilinear", check);
    }
  }
  return check.Result();
}

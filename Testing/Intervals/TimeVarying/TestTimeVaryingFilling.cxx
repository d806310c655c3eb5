// SPDX-License-Identifier: BSD-3-Clause
// Adjacent intervals fill the domain in space and time without cracks, on every grid, static and
// moving, over several slabs. Independent random values do not equal a bound.
#include "Support/TimeVarying/ReferenceFilling.h"

#include "vtkDataSet.h"
#include "vtkPointSet.h"

int TestTimeVaryingFilling(int, char*[])
{
  using namespace reference;
  Check check;
  const std::vector<double> bounds = { 0.0, 0.2, 0.21, 0.6, 1.0 };
  const std::vector<double> times = { -0.5, 0.25, 0.3, 2 };
  for (unsigned int seed = 1; seed <= 2; ++seed)
  {
    for (const NamedGrid& grid : MakeAllGridTypes({ 2, 2, 2 }, seed))
    {
      FillingCounts counts;
      const auto fill = [&](const TimeSteps& steps, const std::string& how)
      {
        check.SetContext(grid.Name + ", " + how + ", seed " + std::to_string(seed));
        AddRandomTimeField(steps, seed);
        CheckFilling(steps, bounds, true, check, counts);
      };
      fill(RepeatGrid(grid.Data, times), "standing");
      if (vtkPointSet::SafeDownCast(grid.Data) && HasBoxDomain(grid.Data))
      {
        const TimeSteps moving = RepeatGrid(grid.Data, times);
        PerturbInteriorPoints(moving, 0.02 * grid.Data->GetLength(), seed);
        fill(moving, "interior points moving");
        MovePoints(moving, Stretch);
        fill(moving, "stretched, and interior points moving");
      }
      Print(counts, grid.Name);
    }
  }
  return check.Result();
}

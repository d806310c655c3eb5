// SPDX-License-Identifier: BSD-3-Clause
// Values equal to the bounds, including entire cells and slabs: adjacent intervals fill the domain
// in space and time without overlap.
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/TimeVarying/ReferenceFilling.h"
#include "Support/TimeVarying/ReferenceSimplices.h"
#include "Support/TimeVarying/ReferenceSpaceTime.h"
#include "Support/TimeVarying/ReferenceTimeVarying.h"

#include "vtkUnstructuredGrid.h"

namespace
{

using namespace reference;

/// Every value is 3: the interval that contains 3 contains the entire domain, as in
/// vtkIntervalVolume.
void CheckConstant(Check& check)
{
  const struct
  {
    const char* Name;
    std::vector<Interval> Intervals;
    int Holder;
  } cases[] = { { "lower bound", { { 3, 4 } }, 0 }, { "upper bound", { { 2, 3 } }, 0 },
    { "both bounds", { { 3, 3 } }, 0 }, { "a shared bound", { { 2, 3 }, { 3, 4 } }, 1 },
    { "no bound", { { 2, 4 } }, 0 } };
  for (MeshKind kind : { MeshKind::Tetrahedra5, MeshKind::Mixed })
  {
    const TimeSteps steps = RepeatGrid(MakeMesh(kind, { 2, 2, 2 }), { 0, 1, 3 });
    AddSpaceTimeField(steps, [](const std::array<double, 3>&, double, vtkIdType) { return 3.0; });
    for (const auto& one : cases)
    {
      check.SetContext(GetName(kind) + ", constant and equal to " + one.Name);
      const TimeVaryingExtraction found = ExtractTimeVarying(steps, { one.Intervals });
      const auto in = [&](int interval)
      {
        return static_cast<double>(
          MeasureWeightedTetrahedra(found.Tetrahedra, interval).SumOfAbsolute);
      };
      check.Near(in(one.Holder), 24, 1e-12, "hypervolume of the interval that contains the value");
      check.Near(in(Any), 24, 1e-12, "hypervolume of all intervals");
      check.Near(static_cast<double>(MeasureSimplices(found.Simplices).Sum), 24, 1e-12,
        "hypervolume of the 4-simplices");
    }
  }
}

}

int TestTimeVaryingTies(int, char*[])
{
  Check check;
  for (unsigned int seed = 1; seed <= 3; ++seed)
  {
    for (const NamedGrid& grid : MakeAllGridTypes({ 2, 2, 2 }, seed))
    {
      FillingCounts counts;
      const TimeSteps steps = RepeatGrid(grid.Data, { 0, 1, 2.5 });
      for (int values : { 2, 3, 5 })
      {
        check.SetContext(
          grid.Name + ", " + std::to_string(values) + " values, seed " + std::to_string(seed));
        AddIntegerTimeField(steps, values, seed);
        CheckFilling(steps, { 0, 1, 1.5, 2, static_cast<double>(values) }, false, check, counts);
      }
      Print(counts, grid.Name);
    }
  }
  CheckConstant(check);
  return check.Result();
}

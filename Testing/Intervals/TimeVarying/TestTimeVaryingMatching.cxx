// SPDX-License-Identifier: BSD-3-Clause
// Documented guarantees for values equal to bounds, in time and for slices: 4-simplices match with
// opposite orientation over all slabs, boundaries are complete, and the slice at a step equals the
// interval volume of that step, tetrahedron by tetrahedron. Tested with shared upper bounds, where
// equal values are outside, and with other upper bounds, where they are inside.
#include "Support/Inputs/DataFiles.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Intervals/ReferenceMatching.h"
#include "Support/TimeVarying/ReferenceTimeSteps.h"

#include "vtkDataSet.h"
#include "vtkImageData.h"

namespace
{

using namespace reference;

/// Uses three subvolumes of a volume, each shifted by one more voxel, as three time steps.
void CheckVolume(const std::string& file, Check& check)
{
  check.SetContext(file);
  const auto volume = interlume::ReadData(file);
  TimeSteps steps;
  for (int step = 0; step < 3; ++step)
  {
    steps.push_back({ 0.5 * step, CropVolume(*volume, 8, step) });
  }
  const std::vector<double> bounds = GetQuantiles(*GetDataSet(steps.front()));
  CheckMatchingInTime(steps,
    { { bounds[0], bounds[1] }, { bounds[1], bounds.back() }, { bounds[1], bounds[1] },
      { bounds[0], bounds[0] } },
    check);
  check.SetContext(file + ", upper bounds that are not shared");
  std::vector<Interval> closed;
  for (size_t i = 0; i + 1 < bounds.size(); i += 2)
  {
    closed.push_back({ bounds[i], bounds[i + 1] });
  }
  CheckMatchingInTime(steps, closed, check);
}

void CheckGrid(const NamedGrid& grid, Check& check)
{
  for (int values : { 2, 3, 5 })
  {
    for (unsigned int seed = 1; seed <= 3; ++seed)
    {
      const std::string name =
        grid.Name + ", " + std::to_string(values) + " values, seed " + std::to_string(seed);
      check.SetContext(name);
      const TimeSteps steps = RepeatGrid(grid.Data, { 0, 1, 2.5, 3 });
      AddIntegerTimeField(steps, values, seed);
      CheckMatchingInTime(
        steps, { { 0, 1 }, { 1, values - 1.0 }, { 0, 0 }, { 1, 1 }, { 0.5, 1 } }, check);
      if (seed == 1)
      {
        check.SetContext(name + ", upper bounds that are not shared");
        CheckMatchingInTime(steps, { { 0, 1 }, { 0.5, 1 }, { 1, 1 }, { 1.5, 2 } }, check);
      }
    }
  }
}

}

int TestTimeVaryingMatching(int, char*[])
{
  Check check;
  for (const std::string& file : GetTiedVolumeFileNames())
  {
    CheckVolume(file, check);
  }
  for (const NamedGrid& grid : MakeAllGridTypes({ 2, 2, 2 }, 3))
  {
    CheckGrid(grid, check);
  }
  return check.Result();
}

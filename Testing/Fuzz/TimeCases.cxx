// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzCases.h"
#include "FuzzData.h"
#include "FuzzRun.h"

#include "Support/TimeVarying/ReferenceTemporal.h"
#include "Support/TimeVarying/ReferenceTimeSteps.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSimplexTimeSlice.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <vector>

namespace fuzz
{

namespace
{

/// Checks that all values of an array are within bounds, with a tolerance for rounding.
void CheckRange(
  vtkUnstructuredGrid* grid, const char* name, double lower, double upper, reference::Check& check)
{
  vtkDataArray* array = grid->GetPointData()->GetArray(name);
  array = array ? array : grid->GetCellData()->GetArray(name);
  if (!array || array->GetNumberOfTuples() == 0)
  {
    return;
  }
  double range[2];
  array->GetRange(range);
  const double tolerance = 1e-6 * std::max(upper - lower, 1e-300);
  check.That(range[0] >= lower - tolerance && range[1] <= upper + tolerance,
    std::string(name) + " from " + std::to_string(range[0]) + " to " + std::to_string(range[1]));
}

}

void RunTime(FuzzRandom& random, std::string& text, reference::Check& check)
{
  const FuzzData data = MakeData(random);
  std::vector<double> times = { random.Between(-5.0, 5.0) };
  const int more = random.Integer(random.Chance(0.05) ? 0 : 1, 3);
  for (int i = 0; i < more; ++i)
  {
    times.push_back(times.back() + random.Pick<double>({ 0.1, 1.0, 1e-6, 1e4 }));
  }
  reference::TimeSteps steps = reference::RepeatGrid(data.Data, times);
  const unsigned seed = static_cast<unsigned>(random.Next());
  const bool isTied = random.Chance(0.4);
  const bool hasCriterion = random.Chance(0.3);
  if (isTied)
  {
    reference::AddIntegerTimeField(steps, 3, seed + 1, "g");
    reference::AddIntegerTimeField(steps, 3, seed);
  }
  else
  {
    reference::AddRandomTimeField(steps, seed + 1, "g");
    reference::AddRandomTimeField(steps, seed);
  }
  const double lower = isTied ? random.Integer(0, 2) : random.Unit();
  const double upper =
    isTied ? std::max<double>(lower, random.Integer(0, 2)) : lower + random.Unit();
  const bool hasSimplices = random.Chance(0.5);
  const bool hasBoundaries = random.Chance(0.5);
  const double bound = random.Integer(0, 2);
  const int operation = random.Integer(0, 2);
  text = data.Text + ", " + std::to_string(times.size()) + (isTied ? " tied" : "") + " steps, [" +
    std::to_string(lower) + ", " + std::to_string(upper) + "]" +
    (hasCriterion ? ", criterion " + std::to_string(operation) : "");
  vtkNew<reference::TimeStepSource> source;
  source->SetSteps(steps);
  const auto make = [&]()
  {
    auto filter = vtkSmartPointer<vtkTimeVaryingIntervalVolume>::New();
    filter->SetInputConnection(source->GetOutputPort());
    filter->SetNumberOfIntervals(1);
    filter->SetInterval(0, lower, upper);
    filter->SetGenerateSimplices(hasSimplices);
    filter->SetGenerateBoundaries(hasBoundaries);
    if (hasCriterion)
    {
      filter->AddCriterion("g", 0.5 * bound, bound);
      filter->SetCriteriaOperation(operation);
    }
    return filter;
  };
  CheckRun(make, true, check);
  Messages messages;
  const auto filter = make();
  filter->Update();
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0)))
  {
    CheckRange(grid, "Time", times.front(), times.back(), check);
    CheckRange(grid, "DeltaT", 0.0, times.back() - times.front(), check);
  }
  if (hasSimplices)
  {
    vtkNew<vtkSimplexTimeSlice> slice;
    slice->SetInputConnection(filter->GetOutputPort(2));
    slice->SetTime(random.Between(times.front(), times.back()));
    slice->SetSliceAxis(random.Chance(0.5) ? vtkSimplexTimeSlice::TIME_AXIS : random.Integer(0, 4));
    slice->SetPosition(random.Between(-1.0, 1.0));
    slice->Update();
    check.That(slice->GetOutputDataObject(0) != nullptr, "the time slice has an output");
  }
}

}

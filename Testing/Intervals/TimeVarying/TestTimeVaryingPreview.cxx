// SPDX-License-Identifier: BSD-3-Clause
// Previews over time: fewer steps and coarser grids, requested once, without effect on later
// executions.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceLattice.h"
#include "Support/TimeVarying/ReferenceTemporal.h"
#include "Support/TimeVarying/ReferenceTimeVarying.h"

#include "vtkCellArray.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTetra.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <iterator>
#include <random>

namespace
{

using namespace reference;

const std::vector<double> Times = { 0.0, 0.5, 1.0, 2.0, 2.25, 3.0, 4.0, 4.5 };
const std::array<int, 3> Cells = { 6, 5, 7 };
constexpr vtkIdType AllCells = 6 * 5 * 7;
constexpr int Slabs = 7;

/// Returns the integral of the duration over space.
double IntegrateDuration(vtkUnstructuredGrid* grid)
{
  vtkDataArray* durations = grid->GetPointData()->GetArray("DeltaT");
  vtkNew<vtkIdList> ids;
  double sum = 0.0;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    grid->GetCellPoints(cell, ids);
    double corners[4][3];
    double duration = 0.0;
    for (int i = 0; i < 4; ++i)
    {
      grid->GetPoint(ids->GetId(i), corners[i]);
      duration += durations->GetTuple1(ids->GetId(i)) / 4.0;
    }
    sum +=
      duration * std::abs(vtkTetra::ComputeVolume(corners[0], corners[1], corners[2], corners[3]));
  }
  return sum;
}

vtkUnstructuredGrid* Update(TimeVaryingPipeline& pipeline, vtkIdType limit)
{
  pipeline.Filter->SetPreviewCellLimit(limit);
  pipeline.Filter->Update();
  return vtkUnstructuredGrid::SafeDownCast(pipeline.Filter->GetOutputDataObject(0));
}

/// A field that is linear in space and time has the same region on all grids.
void CheckLinear(Check& check)
{
  for (const DataSetVariant& form : FormsOf(MakeImage(Cells)))
  {
    check.SetContext(form.Name);
    const TimeSteps steps = RepeatGrid(form.Data, Times);
    AddSpaceTimeField(steps,
      [](const std::array<double, 3>& x, double time, vtkIdType)
      { return 0.3 + 0.7 * x[0] - 0.4 * x[1] + 0.9 * x[2] + 0.8 * time; });
    TimeVaryingPipeline pipeline(steps, { { { 2.0, 5.0 } } });
    const double exact = IntegrateDuration(Update(pipeline, 0));
    check.That(exact > 0.0, "the region is not empty");
    const bool isStructured = !vtkUnstructuredGrid::SafeDownCast(form.Data);
    for (const vtkIdType limit : { AllCells * 4, AllCells * 2, AllCells / 2, vtkIdType(1) })
    {
      const double preview = IntegrateDuration(Update(pipeline, limit));
      check.Near(preview, exact, 1e-5, "duration of the preview for " + std::to_string(limit));
      const vtkIdType cells = pipeline.Filter->GetReport()->GetCount("Cells");
      check.That(!isStructured || limit == 1 || cells <= limit,
        "the preview has " + std::to_string(cells) + " cells for " + std::to_string(limit));
    }
  }
}

/// The first preview requests its steps once. Later ones request none, until the input changes.
void CheckRequests(Check& check)
{
  const TimeSteps steps = RepeatGrid(MakeImage(Cells), Times);
  AddRandomTimeField(steps, 4);
  TimeVaryingPipeline pipeline(steps, { { { 0.2, 0.5 } } });
  const auto expect = [&](vtkIdType limit, const std::vector<int>& requests, const char* what)
  {
    pipeline.Source->ClearRequests();
    Update(pipeline, limit);
    check.That(pipeline.Source->GetRequests() == requests, what);
  };
  const std::vector<int> all = { 0, 1, 2, 3, 4, 5, 6, 7 };
  expect(AllCells * 4, { 0, 2, 4, 6, 7 }, "the first preview requests every second step");
  for (const double upper : { 0.6, 0.7 })
  {
    pipeline.Filter->SetInterval(0, 0.3, upper);
    expect(AllCells * 4, {}, "further previews request no step");
  }
  pipeline.Source->Modified();
  pipeline.Filter->SetInterval(0, 0.3, 0.8);
  expect(AllCells * 4, { 0, 2, 4, 6, 7 }, "a modified source is requested again");
  pipeline.Filter->SetTimeStepRange(2, 5);
  expect(AllCells * 4, { 2, 3, 4, 5 }, "other steps are requested");
  pipeline.Filter->SetTimeStepRange(0, 7);
  expect(0, all, "without preview, all steps are requested");
  expect(AllCells * Slabs, all, "a preview below the limit has all steps");
}

/// Any sequence of previews and exact executions has the output of fresh filters.
void CheckSequence(bool isComposite, Check& check)
{
  TimeSteps steps = RepeatGrid(MakeImage({ 3, 4, 3 }), Times);
  AddRandomTimeField(steps, 7);
  for (TimeStep& step : steps)
  {
    if (isComposite)
    {
      auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
      blocks->SetNumberOfBlocks(3);
      blocks->SetBlock(0, step.Data);
      blocks->SetBlock(2, step.Data);
      step.Data = blocks;
    }
  }
  TimeVaryingPipeline retained(steps, { { { 0.2, 0.5 } } });
  std::mt19937 random(5);
  std::uniform_real_distribution<double> bound(0.0, 1.0);
  const vtkIdType limits[] = { 0, 1, 60, 200, 100000 };
  for (int step = 0; step < 15; ++step)
  {
    check.SetContext((isComposite ? "blocks, step " : "step ") + std::to_string(step));
    const double lower = bound(random);
    const double upper = lower + bound(random);
    const vtkIdType limit = limits[random() % std::size(limits)];
    TimeVaryingPipeline fresh(steps, { { { lower, upper } } });
    retained.Filter->SetInterval(0, lower, upper);
    Update(retained, limit);
    Update(fresh, limit);
    for (int port = 0; port < 3; ++port)
    {
      vtkDataObject* found = retained.Filter->GetOutputDataObject(port);
      vtkDataObject* expected = fresh.Filter->GetOutputDataObject(port);
      for (unsigned int block = 0; block < (isComposite ? 3u : 1u); ++block)
      {
        const auto grid = [&](vtkDataObject* output)
        {
          return vtkUnstructuredGrid::SafeDownCast(
            isComposite ? vtkMultiBlockDataSet::SafeDownCast(output)->GetBlock(block) : output);
        };
        check.That(!grid(found) == !grid(expected), "blocks exist");
        const std::string difference =
          grid(found) ? FindDifference(grid(found), grid(expected)) : std::string();
        check.That(difference.empty(), difference);
      }
    }
  }
}

void CheckSequences(Check& check)
{
  CheckSequence(false, check);
  CheckSequence(true, check);
}

void CheckMessages(Check& check)
{
  const TimeSteps steps = RepeatGrid(MakeImage(Cells), Times);
  AddRandomTimeField(steps, 4);
  TimeVaryingPipeline pipeline(steps, { { { 5.0, 6.0 } } });
  for (const vtkIdType limit : { AllCells, AllCells * Slabs })
  {
    pipeline.Filter->SetPreviewCellLimit(limit);
    check.That(WarningsOf(pipeline.Filter).empty(), "a preview does not warn");
  }
  pipeline.Filter->SetPreviewCellLimit(0);
  check.Contains(WarningsOf(pipeline.Filter), "The output is empty");
  pipeline.Filter->SetPreviewCellLimit(AllCells);
  pipeline.Filter->SetTimeStepRange(3, 3);
  check.Contains(UpdateAndGetErrors(pipeline.Filter), "At least two time steps");
}

}

int TestTimeVaryingPreview(int, char*[])
{
  return RunChecks({ CheckLinear, CheckRequests, CheckSequences, CheckMessages });
}

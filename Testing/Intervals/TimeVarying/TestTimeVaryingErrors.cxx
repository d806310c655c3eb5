// SPDX-License-Identifier: BSD-3-Clause
// Invalid steps and settings: an error names the problem and the step, outputs are empty, and the
// filter works again after a correction.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Meshes/ReferenceLattice.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Meshes/ReferenceTransform.h"
#include "Support/TimeVarying/ReferenceTemporal.h"
#include "Support/TimeVarying/ReferenceTimeVarying.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkUnstructuredGrid.h"

#include <functional>
#include <limits>

namespace
{

using namespace reference;

const double NaN = std::numeric_limits<double>::quiet_NaN();
const double Infinity = std::numeric_limits<double>::infinity();

TimeSteps MakeSteps(vtkDataSet* grid, const std::vector<double>& times = { 0, 1, 2, 3 })
{
  const TimeSteps steps = RepeatGrid(grid, times);
  AddRandomTimeField(steps, 1);
  return steps;
}

TimeSteps MakeMixed(const std::vector<double>& times = { 0, 1, 2, 3 })
{
  return MakeSteps(MakeMesh(MeshKind::Mixed, { 2, 2, 2 }), times);
}

/// Returns four time steps of \a grid, but with \a other as step 2.
TimeSteps With(vtkDataSet* grid, vtkDataSet* other)
{
  TimeSteps steps = MakeSteps(grid, { 10, 10.5, 11, 13 });
  steps[2].Data = MakeSteps(other, { 11 }).front().Data;
  return steps;
}

struct ErrorCase
{
  std::string Name;
  TimeSteps Steps;
  /// Strings that the message must contain: the index of a step, its time, or another value.
  std::vector<std::string> Named;
  std::function<void(vtkTimeVaryingIntervalVolume*)> Break = [](vtkTimeVaryingIntervalVolume*) {};
  bool HasTimes = true;
};

bool IsEmpty(vtkDataObject* data)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  return data && (!grid || (grid->GetNumberOfCells() == 0 && grid->GetNumberOfPoints() == 0));
}

std::vector<ErrorCase> StepCases()
{
  const auto mixed = MakeMesh(MeshKind::Mixed, { 2, 2, 2 });
  const auto boxes = MakeMesh(MeshKind::Hexahedra, { 2, 2, 2 });
  const auto image = MakeImage({ 3, 3, 3 });
  std::vector<ErrorCase> cases = { { "one step", MakeMixed({ 5 }), { "1" } },
    { "decreasing times", MakeMixed({ 0, 2.25, 1.125, 3 }), { "step 2", "1.125" } },
    { "a time that is NaN", MakeMixed({ 0, 1, NaN, 3 }), { "step 2", "nan" } },
    { "a time that is infinite", MakeMixed({ 0, 1, 2, Infinity }), { "step 3", "inf" } },
    { "more cells", With(boxes, MakeMesh(MeshKind::Hexahedra, { 3, 2, 2 })), { "step 2" } },
    { "other cells on the same points", With(boxes, RotateCellPointOrder(boxes, 3)), { "step 2" } },
    { "cells of another type", With(boxes, MakeMesh(MeshKind::Voxels, { 2, 2, 2 })), { "step 2" } },
    { "points with other numbers", With(mixed, RenumberPoints(mixed, 3)), { "step 2" } },
    { "polyhedra with other faces",
      With(MakeMesh(MeshKind::Boxes, { 2, 2, 2 }),
        RotateCellPointOrder(MakeMesh(MeshKind::Boxes, { 2, 2, 2 }), 5)),
      { "step 2" } },
    { "another type of grid", With(image, boxes), { "step 2" } },
    { "an image of other dimensions", With(image, MakeImage({ 3, 4, 3 })), { "step 2" } },
    { "the same number of points in other dimensions",
      With(MakeImage({ 3, 4, 3 }), MakeImage({ 4, 3, 3 })), { "step 2" } } };
  {
    ErrorCase missing = { "a step without the array", MakeMixed(), { "\"f\"", "step 2" } };
    GetDataSet(missing.Steps[2])->GetPointData()->RemoveArray("f");
    missing.Break = [](vtkTimeVaryingIntervalVolume* filter)
    { filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "f"); };
    cases.push_back(missing);
  }
  {
    ErrorCase vectors = { "a step whose array has three components", MakeMixed(),
      { "\"f\"", "step 2", "3" } };
    vtkNew<vtkDoubleArray> array;
    array->SetName("f");
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(GetDataSet(vectors.Steps[2])->GetNumberOfPoints());
    array->FillValue(0.5);
    GetDataSet(vectors.Steps[2])->GetPointData()->AddArray(array);
    cases.push_back(vectors);
  }
  {
    // Messages name steps by their index in the input, not in the range.
    ErrorCase late = { "more cells, in a range", With(boxes, mixed), { "step 2" } };
    late.Break = [](vtkTimeVaryingIntervalVolume* filter) { filter->SetTimeStepRange(1, 3); };
    cases.push_back(late);
    late.Name = "decreasing times in a range";
    late.Steps = MakeMixed({ 0, 2.25, 1.125, 3 });
    cases.push_back(late);
  }
  {
    ErrorCase none = { "no times", MakeMixed(), {} };
    none.HasTimes = false;
    cases.push_back(none);
  }
  return cases;
}

std::vector<ErrorCase> SettingCases()
{
  using Filter = vtkTimeVaryingIntervalVolume;
  const TimeSteps steps = MakeMixed();
  return { { "lower above upper", steps, { "0.875", "0.125" },
             [](Filter* filter) { filter->SetInterval(0, 0.875, 0.125); } },
    { "a bound that is NaN", steps, { "nan" },
      [](Filter* filter) { filter->SetInterval(0, NaN, 0.5); } },
    { "a bound that is infinite", steps, { "inf" },
      [](Filter* filter) { filter->SetInterval(0, 0.5, Infinity); } },
    { "an array that does not exist", steps, { "nosuch" },
      [](Filter* filter) {
        filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "nosuch");
      } },
    { "a range of one step", steps, { "2 to 2" },
      [](Filter* filter) { filter->SetTimeStepRange(2, 2); } },
    { "a reversed range", steps, { "3", "1" },
      [](Filter* filter) { filter->SetTimeStepRange(3, 1); } },
    { "a range outside the steps", steps, { "7" },
      [](Filter* filter) { filter->SetTimeStepRange(7, 9); } },
    { "a zero direction", steps, { "direction" },
      [](Filter* filter) { filter->SetProjectionDirection(0, 0, 0, 0); } },
    { "a direction that is NaN", steps, { "direction" },
      [](Filter* filter) { filter->SetProjectionDirection(0, NaN, 0, 1); } } };
}

void CheckCase(const ErrorCase& one, Check& check)
{
  check.SetContext(one.Name);
  vtkNew<TimeStepSource> source;
  source->SetSteps(one.Steps);
  source->SetReportTimeSteps(one.HasTimes);
  vtkNew<vtkTimeVaryingIntervalVolume> filter;
  filter->SetInputConnection(source->GetOutputPort());
  const TimeVaryingSettings settings = { { { 0.25, 0.75 } } };
  Apply(settings, filter);
  one.Break(filter);
  const std::string messages = UpdateAndGetErrors(filter);
  check.That(!messages.empty(), "there is an error");
  for (const std::string& part : one.Named)
  {
    // The message starts with a source line and the address of the object, which are skipped.
    const size_t words = messages.find("): ");
    check.That(words != std::string::npos && messages.find(part, words) != std::string::npos,
      "the error names " + part + ": " + messages);
  }
  for (int port = 0; port < 3; ++port)
  {
    check.That(IsEmpty(filter->GetOutputDataObject(port)), "the output is empty");
  }
  source->SetSteps(MakeMixed());
  source->SetReportTimeSteps(true);
  Apply(settings, filter);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "f");
  const std::string later = UpdateAndGetErrors(filter);
  check.That(later.empty(), "no error after the correction: " + later);
  for (int port = 0; port < 3; ++port)
  {
    auto* grid = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(port));
    check.That(grid && grid->GetNumberOfCells() > 0, "output after the correction");
  }
}

/// An empty result is not an error, but a warning states the reason.
void CheckNothing(Check& check)
{
  vtkNew<TimeStepSource> source;
  vtkNew<vtkTimeVaryingIntervalVolume> filter;
  filter->SetInputConnection(source->GetOutputPort());
  for (const TimeVaryingSettings& settings :
    { TimeVaryingSettings{ {} }, TimeVaryingSettings{ { { 3, 4 } } } })
  {
    check.SetContext(settings.Intervals.empty() ? "no interval" : "an interval without values");
    source->SetSteps(MakeMixed());
    Apply(settings, filter);
    const std::string warning = WarningsOf(filter);
    const std::string expected = settings.Intervals.empty()
      ? "no interval is set"
      : "the interval [3, 4] at any time; the array \"f\" ranges from 0";
    check.That(
      warning.find(expected) != std::string::npos, "the warning states the reason: " + warning);
    for (int port = 0; port < 3; ++port)
    {
      check.That(IsEmpty(filter->GetOutputDataObject(port)), "the output is empty");
    }
  }
  check.SetContext("grids without cells");
  source->SetSteps(MakeSteps(vtkNew<vtkUnstructuredGrid>()));
  Apply({ { { 0.25, 0.75 } } }, filter);
  const std::string warning = WarningsOf(filter);
  check.That(
    warning.find("no points") != std::string::npos, "the warning states the reason: " + warning);
  check.That(IsEmpty(filter->GetOutputDataObject(0)), "the output is empty");
}

/// A block that is missing at one step is an error.
void CheckBlocks(Check& check)
{
  check.SetContext("blocks");
  TimeSteps steps;
  const TimeSteps leaf = MakeMixed();
  for (const TimeStep& step : leaf)
  {
    vtkNew<vtkMultiBlockDataSet> tree;
    tree->SetNumberOfBlocks(2);
    tree->SetBlock(0, step.Data);
    tree->SetBlock(1, step.Time == 2 ? nullptr : step.Data.Get());
    steps.push_back({ step.Time, tree });
  }
  vtkNew<TimeStepSource> source;
  source->SetSteps(steps);
  vtkNew<vtkTimeVaryingIntervalVolume> filter;
  filter->SetInputConnection(source->GetOutputPort());
  Apply({ { { 0.25, 0.75 } } }, filter);
  const std::string messages = UpdateAndGetErrors(filter);
  check.That(messages.find("step 2") != std::string::npos, "the error names the step: " + messages);
}

}

int TestTimeVaryingErrors(int, char*[])
{
  Check check;
  for (const std::vector<ErrorCase>& cases : { StepCases(), SettingCases() })
  {
    for (const ErrorCase& one : cases)
    {
      CheckCase(one, check);
    }
  }
  CheckNothing(check);
  CheckBlocks(check);
  return check.Result();
}

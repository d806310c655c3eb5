// SPDX-License-Identifier: BSD-3-Clause
// Strides of time steps, estimates of the number of tetrahedra, time steps that keep it below a
// limit, and the warning about a large output.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Checks/ReferenceSizeWarning.h"
#include "Support/Inputs/DataFiles.h"
#include "Support/Inputs/ExodusTimeSource.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceLattice.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/TimeVarying/ReferenceSimplices.h"
#include "Support/TimeVarying/ReferenceTemporal.h"
#include "Support/TimeVarying/ReferenceTimeVarying.h"

#include "vtkAnalyticFieldSource.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDeltaWingSource.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTaperedCylinderSource.h"
#include "vtkTimeSlabWriter.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{

using namespace reference;

/// Maximum factor between an estimate and the number of tetrahedra.
constexpr double Accuracy = 1.25;

std::vector<double> MakeTimes(int number)
{
  std::vector<double> times;
  for (int i = 0; i < number; ++i)
  {
    times.push_back(0.5 * i);
  }
  return times;
}

/// Returns an image of the unit cube.
vtkSmartPointer<vtkImageData> MakeCube(int cells)
{
  const auto image = MakeImage({ cells, cells, cells });
  image->SetOrigin(0, 0, 0);
  image->SetSpacing(1.0 / cells, 1.0 / cells, 1.0 / cells);
  return image;
}

/// A stride selects the same slabs as an input that has only the selected steps.
void CheckStride(Check& check)
{
  const TimeSteps steps = RepeatGrid(MakeMesh(MeshKind::Mixed, { 3, 3, 3 }), MakeTimes(9));
  AddRandomTimeField(steps, 5);
  const struct
  {
    int First;
    int Last;
    int Stride;
    std::vector<int> Selected;
  } cases[] = { { 0, VTK_INT_MAX, 1, { 0, 1, 2, 3, 4, 5, 6, 7, 8 } },
    { 0, VTK_INT_MAX, 2, { 0, 2, 4, 6, 8 } }, { 0, VTK_INT_MAX, 3, { 0, 3, 6, 8 } },
    { 1, 7, 3, { 1, 4, 7 } }, { 2, 7, VTK_INT_MAX, { 2, 7 } }, { -3, 4, 4, { 0, 4 } } };
  for (const auto& one : cases)
  {
    check.SetContext("stride " + std::to_string(one.Stride));
    TimeVaryingPipeline pipeline(steps, { { { 0.2, 0.45 } } });
    pipeline.Filter->SetTimeStepRange(one.First, one.Last);
    pipeline.Filter->SetTimeStepStride(one.Stride);
    pipeline.Filter->Update();
    check.That(pipeline.Source->GetRequests() == one.Selected, "the requested steps");
    TimeSteps selected;
    for (const int step : one.Selected)
    {
      selected.push_back(steps[static_cast<std::size_t>(step)]);
    }
    const TimeVaryingExtraction expected = ExtractTimeVarying(selected, { { { 0.2, 0.45 } } });
    const std::vector<std::string> values = { "IntervalId", "SimplexClass", "TimeSlab" };
    check.That(GeometricSet(pipeline.Filter->GetOutput(), values, "DeltaT") ==
        GeometricSet(expected.Tetrahedra, values, "DeltaT"),
      "the tetrahedra of the selected steps");
  }
  check.SetContext("stride");
  vtkNew<vtkTimeVaryingIntervalVolume> filter;
  check.Equal(filter->GetTimeStepStride(), 1, "default");
  filter->SetTimeStepStride(-2);
  check.Equal(filter->GetTimeStepStride(), 1, "a negative stride");
  TimeSteps unordered = steps;
  std::swap(unordered[4].Time, unordered[6].Time);
  TimeVaryingPipeline pipeline(unordered, { { { 0.2, 0.45 } } });
  pipeline.Filter->SetTimeStepStride(2);
  check.Contains(
    UpdateAndGetErrors(pipeline.Filter), "Time step 6 (time 2) is before time step 4 (time 3).");
}

/// Sets the interval to the upper half of the range over all time steps.
void SetUpperHalf(vtkTimeVaryingIntervalVolume* filter, const TimeSteps& steps)
{
  double range[2] = { VTK_DOUBLE_MAX, VTK_DOUBLE_MIN };
  for (const TimeStep& step : steps)
  {
    double some[2];
    GetDataSet(step)->GetPointData()->GetScalars()->GetRange(some);
    range[0] = std::min(range[0], some[0]);
    range[1] = std::max(range[1], some[1]);
  }
  filter->SetInterval(0, 0.5 * (range[0] + range[1]), range[1]);
}

vtkIdType CountTetrahedra(vtkTimeVaryingIntervalVolume* filter)
{
  filter->SetSizeWarningLimit(0);
  filter->Update();
  return filter->GetOutput()->GetNumberOfCells();
}

void CheckAccuracy(double estimate, double number, const std::string& what, Check& check)
{
  check.That(number > 0.0 && estimate < Accuracy * number && estimate > number / Accuracy,
    what + ": " + std::to_string(estimate) + " for " + std::to_string(number));
}

/// Checks the estimate and the proposed steps for a series.
void CheckSeries(vtkTimeVaryingIntervalVolume* filter, Check& check)
{
  const vtkIdType all = CountTetrahedra(filter);
  const auto count = [filter, all](int stride)
  {
    filter->SetTimeStepStride(stride);
    return static_cast<double>(
      stride > 1 || filter->GetTimeStepRange()[1] != VTK_INT_MAX ? CountTetrahedra(filter) : all);
  };
  for (const int stride : { 1, 3 })
  {
    filter->SetTimeStepStride(stride);
    const vtkIdType estimate = filter->EstimateNumberOfTetrahedra();
    CheckAccuracy(static_cast<double>(estimate), count(stride),
      "estimate with stride " + std::to_string(stride), check);
  }
  filter->SetTimeStepStride(1);
  for (const double fraction : { 2.0, 0.6, 0.35 })
  {
    const auto limit = static_cast<vtkIdType>(fraction * static_cast<double>(all));
    filter->SetSizeWarningLimit(limit);
    const vtkIdType estimate = filter->LimitTimeSteps();
    const int stride = filter->GetTimeStepStride();
    const std::string what = " with " + std::to_string(fraction) + " of all";
    check.That(estimate <= limit, "the estimate is below the limit" + what);
    CheckAccuracy(static_cast<double>(estimate), count(stride), "proposed steps" + what, check);
    check.That((stride == 1) == (fraction > 1.0), "a stride if necessary" + what);
    if (stride > 1)
    {
      check.That(count(stride - 1) > static_cast<double>(limit) / Accuracy,
        "a lower stride exceeds the limit" + what);
    }
    filter->SetTimeStepStride(1);
    filter->SetTimeStepRange(0, VTK_INT_MAX);
  }
}

/// A series made from a dataset of Data/ by a drift of its values.
void CheckData(const char* name, Check& check)
{
  check.SetContext(name);
  const vtkSmartPointer<vtkDataSet> data = interlume::ReadData(name);
  vtkPointData* arrays = data->GetPointData();
  for (int a = 0; a < arrays->GetNumberOfArrays() && !arrays->GetScalars(); ++a)
  {
    if (arrays->GetArray(a)->GetNumberOfComponents() == 1)
    {
      arrays->SetActiveScalars(arrays->GetArrayName(a));
    }
  }
  vtkDataArray* scalars = arrays->GetScalars();
  double range[2];
  scalars->GetRange(range);
  const TimeSteps steps = RepeatGrid(data, MakeTimes(9));
  AddSpaceTimeField(steps,
    [&](const std::array<double, 3>&, double time, vtkIdType point)
    {
      // The drift is faster at first.
      const double value = (scalars->GetComponent(point, 0) - range[0]) / (range[1] - range[0]);
      return value * (1.0 + 0.5 * std::sqrt(time / 4.0));
    });
  TimeVaryingPipeline pipeline(steps, { {} });
  pipeline.Filter->SetGenerateBoundaries(false);
  pipeline.Filter->GenerateSimplicesOff();
  SetUpperHalf(pipeline.Filter, steps);
  CheckSeries(pipeline.Filter, check);
}

void CheckSources(Check& check)
{
  const auto run = [&check](auto* source, double lower, double upper)
  {
    check.SetContext(source->GetClassName());
    source->SetNumberOfTimeSteps(11);
    vtkNew<vtkTimeVaryingIntervalVolume> filter;
    filter->SetInputConnection(source->GetOutputPort());
    filter->SetInterval(0, lower, upper);
    CheckSeries(filter, check);
  };
  vtkNew<vtkAnalyticFieldSource> vortex;
  vortex->SetFieldToVortex();
  vortex->SetDimensions(26, 26, 26);
  run(vortex.GetPointer(), 0.6, 2.0);
  vtkNew<vtkDeltaWingSource> wing;
  wing->SetDimensions(26, 26, 26);
  run(wing.GetPointer(), 0.48, 1.0);
  vtkNew<vtkTaperedCylinderSource> cylinder;
  cylinder->SetDimensions(32, 32, 16);
  run(cylinder.GetPointer(), 0.9934, 0.9944);
  check.SetContext("mug.ex2");
  vtkNew<interlume::ExodusTimeSource> mug;
  mug->SetFileName(interlume::DataFile("mug.ex2"));
  vtkNew<vtkTimeVaryingIntervalVolume> filter;
  filter->SetInputConnection(mug->GetOutputPort());
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "convected");
  filter->SetInterval(0, 0.2, 0.7);
  CheckSeries(filter, check);
}

/// The wavelet of vtkRTAnalyticSource, moving along x, on a grid with far more cells than the
/// sample.
void CheckWavelet(Check& check)
{
  check.SetContext("wavelet");
  const TimeSteps steps = RepeatGrid(MakeCube(48), MakeTimes(11));
  AddSpaceTimeField(steps,
    [](const std::array<double, 3>& x, double time, vtkIdType)
    {
      const double p[3] = { x[0] - 0.5 - 0.02 * time, x[1] - 0.5, x[2] - 0.5 };
      return 255 * std::exp(-2 * (p[0] * p[0] + p[1] * p[1] + p[2] * p[2])) +
        10 * std::sin(60 * p[0]) + 18 * std::sin(30 * p[1]) + 5 * std::cos(40 * p[2]);
    });
  TimeVaryingPipeline pipeline(steps, { {} });
  pipeline.Filter->SetGenerateBoundaries(false);
  pipeline.Filter->GenerateSimplicesOff();
  pipeline.Filter->SetInterval(0, 190, 210);
  CheckSeries(pipeline.Filter, check);
  // The first slab represents a steady series, so the first warning is accurate.
  const vtkIdType number = CountTetrahedra(pipeline.Filter);
  pipeline.Filter->SetSizeWarningLimit(number / 2);
  pipeline.Source->ClearRequests();
  vtkNew<vtkCallbackCommand> count;
  struct Seen
  {
    TimeStepSource* Source;
    std::size_t Requests = 0;
  } seen{ pipeline.Source };
  count->SetClientData(&seen);
  count->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*)
    {
      auto* one = static_cast<Seen*>(data);
      one->Requests = one->Source->GetRequests().size();
    });
  pipeline.Filter->AddObserver(vtkCommand::WarningEvent, count);
  const std::string warning = WarningsOf(pipeline.Filter);
  const std::vector<ReportedSize> sizes = FindSizes(warning);
  check.Equal(static_cast<long long>(seen.Requests), 2, "steps requested before the warning");
  if (check.Equal(static_cast<long long>(sizes.size()), 1, "warnings"))
  {
    CheckAccuracy(sizes[0].Tetrahedra, static_cast<double>(number), "the warning", check);
    const double bytes = 1024.0 * pipeline.Filter->GetOutput()->GetActualMemorySize() +
      static_cast<double>(pipeline.Filter->GetReport()->GetCount("WorkingBytes"));
    CheckAccuracy(sizes[0].Bytes, bytes, "memory of the warning", check);
  }
  for (const char* part :
    { "about ", "(estimated from 1 of 10 time slabs)", "TimeStepStride, now 1", "to about ",
      "LimitTimeSteps", "narrower intervals", "coarser input", "vtkTimeSlabWriter" })
  {
    check.Contains(ToSingleLine(warning), part);
  }
}

/// Growing data exceed the limit only later: the warning comes before the last slab.
void CheckGrowth(Check& check)
{
  check.SetContext("growth");
  const TimeSteps steps = RepeatGrid(MakeCube(20), MakeTimes(11));
  AddSpaceTimeField(steps,
    [](const std::array<double, 3>& x, double time, vtkIdType)
    { return 20 * std::hypot(x[0] - 0.5, x[1] - 0.5, x[2] - 0.5) - 1.7 * time; });
  TimeVaryingPipeline pipeline(steps, { { { -1, 1 } } });
  const vtkIdType number = CountTetrahedra(pipeline.Filter);
  pipeline.Filter->SetSizeWarningLimit(11 * number / 10);
  check.That(WarningsOf(pipeline.Filter).empty(), "no warning below the limit");
  pipeline.Filter->SetSizeWarningLimit(9 * number / 10);
  for (int execution = 0; execution < 2; ++execution)
  {
    pipeline.Filter->Modified();
    check.Equal(static_cast<long long>(FindSizes(WarningsOf(pipeline.Filter)).size()), 1,
      "warnings of an execution");
  }
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1); });
  pipeline.Filter->AddObserver(vtkCommand::WarningEvent, abort);
  pipeline.Filter->SetSizeWarningLimit(10);
  pipeline.Source->ClearRequests();
  pipeline.Filter->Update();
  check.Equal(pipeline.Filter->GetOutput()->GetNumberOfCells(), 0, "cells after an abort");
  check.Equal(static_cast<long long>(pipeline.Source->GetRequests().size()), 2,
    "steps requested before an abort by the warning");
}

/// The datasets of a composite input count together.
void CheckComposite(Check& check)
{
  check.SetContext("composite");
  const TimeSteps single = RepeatGrid(MakeMesh(MeshKind::Mixed, { 6, 6, 6 }), MakeTimes(4));
  AddRandomTimeField(single, 5);
  TimeSteps composite;
  for (const TimeStep& step : single)
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(1, GetDataSet(step));
    blocks->SetBlock(2, GetDataSet(step));
    composite.push_back({ step.Time, blocks });
  }
  TimeVaryingPipeline one(single, { { { 0.2, 0.45 } } });
  const vtkIdType number = CountTetrahedra(one.Filter);
  TimeVaryingPipeline two(composite, { { { 0.2, 0.45 } } });
  CheckAccuracy(
    static_cast<double>(two.Filter->EstimateNumberOfTetrahedra()), 2.0 * number, "estimate", check);
  two.Filter->SetSizeWarningLimit(3 * number / 2);
  const std::vector<ReportedSize> sizes = FindSizes(WarningsOf(two.Filter));
  check.That(sizes.size() == 1, "one warning for two datasets");
  if (!sizes.empty())
  {
    CheckAccuracy(sizes[0].Tetrahedra, 2.0 * number, "the warning", check);
  }
}

/// Inputs that cannot be extracted have no estimate, and the settings do not change.
void CheckInvalid(Check& check)
{
  check.SetContext("invalid");
  vtkNew<vtkTimeVaryingIntervalVolume> unconnected;
  check.Equal(unconnected->LimitTimeSteps(), 0, "no input");
  const TimeSteps steps = RepeatGrid(MakeImage({ 4, 4, 4 }), MakeTimes(9));
  AddRandomTimeField(steps, 5);
  const auto expectNone = [&](const TimeSteps& input, const TimeVaryingSettings& settings,
                            const char* array, const std::string& what)
  {
    TimeVaryingPipeline pipeline(input, settings);
    pipeline.Filter->SetSizeWarningLimit(1);
    if (array)
    {
      pipeline.Filter->SetInputArrayToProcess(
        0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, array);
    }
    check.Equal(pipeline.Filter->LimitTimeSteps(), 0, what);
    check.Equal(pipeline.Filter->EstimateNumberOfTetrahedra(), 0, what + ", estimate");
    check.Equal(pipeline.Filter->GetTimeStepStride(), 1, what + ", stride");
  };
  expectNone({ steps[0] }, { { { 0.2, 0.45 } } }, nullptr, "one time step");
  expectNone(steps, { { { 0.45, 0.2 } } }, nullptr, "an invalid interval");
  expectNone(steps, { { { 0.2, 0.45 } } }, "missing", "a missing array");
  expectNone(steps, { {} }, nullptr, "no interval");
  expectNone(steps, { { { 0.2, 0.45 } }, { { 0, 0, 0, 0 } } }, nullptr, "no direction");
  expectNone(steps, { { { 7, 8 } } }, nullptr, "an empty output");
  TimeSteps different = steps;
  different[4].Data = MakeMesh(MeshKind::Mixed, { 1, 1, 1 });
  expectNone(different, { { { 0.2, 0.45 } } }, nullptr, "different steps");
  // A limit that even one slab exceeds leaves one slab.
  TimeVaryingPipeline pipeline(steps, { { { 0.2, 0.45 } } });
  pipeline.Filter->SetTimeStepRange(1, VTK_INT_MAX);
  pipeline.Filter->SetSizeWarningLimit(1);
  pipeline.Filter->LimitTimeSteps();
  check.That(pipeline.Filter->GetTimeStepRange()[0] == 1 &&
      pipeline.Filter->GetTimeStepRange()[1] == 2 && pipeline.Filter->GetTimeStepStride() == 1,
    "one slab remains");
  vtkNew<vtkTimeSlabWriter> writer;
  check.Equal(writer->GetSizeWarningLimit(), 0, "the writer's default limit");
}

}

int TestTimeVaryingSize(int, char*[])
{
  Check check;
  CheckStride(check);
  for (const char* name :
    { "neghip.vti", "bluntfin.vts", "post.vts", "disk_out_ref.vtu", "post_tets.vtk" })
  {
    CheckData(name, check);
  }
  CheckSources(check);
  CheckWavelet(check);
  CheckGrowth(check);
  CheckComposite(check);
  CheckInvalid(check);
  return check.Result();
}

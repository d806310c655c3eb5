// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/BenchParts.h"

#include "Benchmarks/Data/StoredTimeSteps.h"
#include "Benchmarks/Data/MovingFields.h"
#include "Benchmarks/Intervals/ExtractionMethods.h"
#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Measures/PowerFit.h"
#include "Benchmarks/SpaceTime/Interval4dCases.h"
#include "Benchmarks/SpaceTime/RegionError.h"

#include "vtkIntervalVolume.h"
#include "vtkSimplexTimeSlice.h"
#include "vtkTimeVaryingIntervalVolume.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <string>

namespace interval4d
{
namespace
{
const char* const DifferenceNorm = "symmetric difference, share of the volume";
const char* const VolumeNorm = "volume, relative";
const char* const Slice = "slice";
const char* const SliceAgain = "slice-again";
const char* const Interpolate = "interpolate";
const char* const Sampled = "sampled";

using Region = vtkSmartPointer<vtkUnstructuredGrid>;

/// A field at equidistant times, and at the midpoints between them.
struct FieldSeries
{
  MovingField Field;
  vtkSmartPointer<StoredTimeSteps> Steps;
  vtkSmartPointer<StoredTimeSteps> Midpoints;

  FieldSeries(const MovingField& field, int slabs)
    : Field(field)
    , Steps(vtkSmartPointer<StoredTimeSteps>::New())
    , Midpoints(vtkSmartPointer<StoredTimeSteps>::New())
  {
    const double half = (MovingField::LastTime - MovingField::FirstTime) / (2 * slabs);
    field.Source->SetTimeRange(MovingField::FirstTime, MovingField::LastTime);
    field.Source->SetNumberOfTimeSteps(slabs + 1);
    this->Steps->AddStepsFrom(field.Source);
    field.Source->SetTimeRange(MovingField::FirstTime + half, MovingField::LastTime - half);
    field.Source->SetNumberOfTimeSteps(slabs);
    this->Midpoints->AddStepsFrom(field.Source);
  }

  int GetNumberOfSlabs() const { return this->Midpoints->GetNumberOfSteps(); }
};

Region IntervalVolume(const MovingField& field, vtkDataObject* image)
{
  auto filter =
    methods::NewIntervalVolume(vtkDataSet::SafeDownCast(image), field.Lower, field.Upper);
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  filter->Update();
  return filter->GetOutput();
}

vtkSmartPointer<vtkTimeVaryingIntervalVolume> NewSlab(const FieldSeries& series, int slab)
{
  auto filter =
    Case{ series.Field.Name, series.Steps, series.Field.Lower, series.Field.Upper, {} }.NewFilter();
  filter->SetTimeStepRange(slab, slab + 1);
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  filter->GenerateTetrahedraOff();
  filter->GenerateSimplicesOn();
  return filter;
}

Region SliceOf(vtkDataObject* simplices, double time)
{
  vtkNew<vtkSimplexTimeSlice> slice;
  slice->SetInputDataObject(simplices);
  slice->SetTime(time);
  slice->Update();
  return slice->GetOutput();
}

Region MakeSlice(const FieldSeries& series, int slab)
{
  auto filter = NewSlab(series, slab);
  filter->Update();
  return SliceOf(filter->GetOutputDataObject(2), series.Midpoints->GetStepTime(slab));
}

Region MakeInterpolated(const FieldSeries& series, int slab)
{
  auto* first = vtkImageData::SafeDownCast(series.Steps->GetStep(slab));
  auto* second = vtkImageData::SafeDownCast(series.Steps->GetStep(slab + 1));
  vtkNew<vtkImageData> image;
  image->CopyStructure(first);
  auto mean = vtk::TakeSmartPointer(first->GetPointData()->GetScalars()->NewInstance());
  mean->DeepCopy(first->GetPointData()->GetScalars());
  auto* values = static_cast<double*>(mean->GetVoidPointer(0));
  const auto* other =
    static_cast<const double*>(second->GetPointData()->GetScalars()->GetVoidPointer(0));
  for (vtkIdType id = 0; id < mean->GetNumberOfTuples(); ++id)
  {
    values[id] = 0.5 * (values[id] + other[id]);
  }
  image->GetPointData()->SetScalars(mean);
  return IntervalVolume(series.Field, image);
}

Region MakeSampled(const FieldSeries& series, int slab)
{
  return IntervalVolume(series.Field, series.Midpoints->GetStep(slab));
}

struct Method
{
  const char* Name;
  Region (*Make)(const FieldSeries& series, int slab);
};

constexpr std::size_t NumberOfMethods = 3;
const Method Methods[NumberOfMethods] = { { Slice, MakeSlice }, { Interpolate, MakeInterpolated },
  { Sampled, MakeSampled } };

std::vector<BenchSeconds> TimeMethods(const FieldSeries& series, const BenchOptions& options)
{
  std::vector<BenchWork> works;
  for (const Method& method : Methods)
  {
    works.push_back(WithThreads(1,
      [&series, &method]()
      {
        vtkSmartPointer<vtkObjectBase> last;
        for (int slab = 0; slab < series.GetNumberOfSlabs(); ++slab)
        {
          last = method.Make(series, slab);
        }
        return last;
      }));
  }
  return MeasureAlternately(works, options.GetRepeats());
}

/// The mean error of a method over all slabs, and the number of tetrahedra.
struct MeanError : RegionError
{
  vtkIdType Tetrahedra = 0;

  MeanError(const FieldSeries& series, const Method& method)
  {
    const int slabs = series.GetNumberOfSlabs();
    for (int slab = 0; slab < slabs; ++slab)
    {
      const Region region = method.Make(series, slab);
      const RegionError error =
        MeasureRegionError(series.Field, series.Midpoints->GetStepTime(slab), region);
      this->SymmetricDifference += error.SymmetricDifference / slabs;
      this->Volume += error.Volume / slabs;
      this->Tetrahedra += region->GetNumberOfCells();
    }
  }
};

void AddMethodRows(const FieldSeries& series, const Method& method, const BenchSeconds& seconds,
  const BenchSeconds& baselineSeconds, std::vector<BenchRow>& found, const BenchRows& rows)
{
  const MeanError error(series, method);
  BenchRow row = rows.Make(
    series.Field.Name, method.Name, series.Steps->GetStepTime(1) - series.Steps->GetStepTime(0));
  row.Seconds = seconds;
  if (row.Method == Slice)
  {
    row.Baseline = Interpolate;
    row.BaselineSeconds = baselineSeconds;
  }
  row.Set({ { "threads", 1 }, { "slabs", series.GetNumberOfSlabs() },
    { "cells", series.Steps->GetStep(0)->GetNumberOfElements(vtkDataObject::CELL) },
    { "tetrahedra", error.Tetrahedra } });
  row.SetError(DifferenceNorm, error.SymmetricDifference);
  found.push_back(row);
  row.SetError(VolumeNorm, error.Volume);
  found.push_back(row);
}

/// Adds the rows of a field for each number of slabs, grouped by method.
void AddFieldRows(const MovingField& field, const std::vector<int>& numbersOfSlabs,
  const BenchOptions& options, BenchRows& rows)
{
  std::array<std::vector<BenchRow>, NumberOfMethods> found;
  for (const int slabs : numbersOfSlabs)
  {
    const FieldSeries series(field, slabs);
    const std::vector<BenchSeconds> seconds = TimeMethods(series, options);
    for (std::size_t i = 0; i < NumberOfMethods; ++i)
    {
      AddMethodRows(series, Methods[i], seconds[i], seconds[1], found[i], rows);
    }
  }
  for (const std::vector<BenchRow>& ofOne : found)
  {
    for (const BenchRow& row : ofOne)
    {
      rows.Add(row);
    }
  }
}

void AddSliceAgainRow(const FieldSeries& series, const BenchOptions& options, BenchRows& rows)
{
  auto filter = NewSlab(series, 0);
  filter->Update();
  const auto simplices = vtkSmartPointer<vtkDataObject>(filter->GetOutputDataObject(2));
  const double time = series.Midpoints->GetStepTime(0);
  const std::vector<BenchSeconds> seconds =
    MeasureAlternately({ WithThreads(1, [&]() { return SliceOf(simplices, time); }),
                         WithThreads(1, [&]() { return MakeInterpolated(series, 0); }) },
      options.GetRepeats());
  BenchRow row = rows.Make(series.Field.Name, SliceAgain);
  row.SetTimes(seconds[0], Interpolate, seconds[1]);
  row.Set(
    { { "threads", 1 }, { "4_simplices", simplices->GetNumberOfElements(vtkDataObject::CELL) } });
  rows.Add(row);
}

bool IsOf(const BenchRow& row, const std::string& field, const std::string& method)
{
  // Excludes rounding errors: they have no order of convergence, and an error of 0 cannot be drawn
  // on a logarithmic axis.
  return row.Case == field && row.Method == method && row.ErrorNorm == DifferenceNorm &&
    *row.Error > 1e-12;
}

/// Returns the error of `sampled` for the time step of \a row, which is the spatial error common to
/// all methods.
double GetFloor(const BenchRow& row, const std::vector<BenchRow>& rows)
{
  const auto found = std::find_if(rows.begin(), rows.end(),
    [&row](const BenchRow& other)
    { return IsOf(other, row.Case, Sampled) && other.Parameter == row.Parameter; });
  return found == rows.end() ? 0.0 : *found->Error;
}

void AddOrderRow(const std::string& field, const char* method, BenchRows& rows)
{
  std::vector<double> steps;
  std::vector<double> errors;
  for (const BenchRow& row : rows.Get())
  {
    if (IsOf(row, field, method) && *row.Error > 4.0 * GetFloor(row, rows.Get()))
    {
      steps.push_back(row.Parameter.get<double>());
      errors.push_back(*row.Error);
    }
  }
  if (steps.size() > 1)
  {
    BenchRow row = rows.Make(field, method);
    row.Set({ { "order", FitExponent(steps, errors) }, { "steps", steps.size() } });
    rows.Add(row);
  }
}

/**
 * Measures errors of the regions midway between consecutive equidistant time steps, with one thread
 * and a filled case table. The parameter is the time step, which is halved from row to row.
 * Methods:
 * - `slice`: vtkTimeVaryingIntervalVolume on each slab, then vtkSimplexTimeSlice;
 * - `interpolate`, the baseline: the mean of the fields at both time steps, then vtkIntervalVolume;
 * - `sampled`: the field sampled midway between the steps on the same grid, then vtkIntervalVolume
 *   (sampling is not timed). Its error is purely spatial.
 *
 * There is one row for each error norm. The error is the mean over all regions:
 * - `symmetric difference, share of the volume`: the volume between the surface of the result and
 *   the analytic surface, approximated to first order by integrating the distance between them over
 *   the surface of the result, and divided by the volume of the analytic region;
 * - `volume, relative`: the error of the volume, divided by the volume of the analytic region.
 *
 * The count `order` is the exponent of the symmetric difference as a function of the time step,
 * fitted to errors larger than four times the error of `sampled`. Rows of method `slice-again` have
 * the time of a second slice of the same 4-simplices. Their baseline is `interpolate` for one
 * region.
 */
void AddErrorRows(const BenchOptions& options, BenchRows& rows)
{
  const auto numbersOfSlabs =
    options.Size == BenchOptions::TINY ? std::vector<int>{ 2, 4 } : std::vector<int>{ 4, 8, 16 };
  for (const MovingField& field : MakeMovingFields(options))
  {
    AddFieldRows(field, numbersOfSlabs, options, rows);
    AddOrderRow(field.Name, Slice, rows);
    AddOrderRow(field.Name, Interpolate, rows);
    AddSliceAgainRow(FieldSeries(field, numbersOfSlabs.front()), options, rows);
  }
}

std::vector<BenchClaim> CheckErrorClaims(const std::vector<BenchRow>& rows)
{
  const auto linear = [](const BenchRow& row)
  { return row.Case == "linear" && row.Method == Slice ? row.Error : std::nullopt; };
  return { BenchClaim::AtLeast("slice: error falls with the time step to the power of at least 1.7",
             1.7, rows, CountOf(Slice, "order")),
    BenchClaim::AtMost("slice of a linear field: no error but rounding", 1e-12, rows, linear),
    BenchClaim::AtLeast(
      "a slice of 4-simplices that are there: at most 5 times slower than interpolating first", 0.2,
      rows, RatioOf(SliceAgain)) };
}

std::vector<BenchPlot> MakeErrorPlots(const std::vector<BenchRow>& rows)
{
  std::vector<BenchPlot> plots;
  for (const std::string field : { "wave", "ball" })
  {
    BenchPlot plot = BenchPlot::OfErrors("interval4d-" + field,
      field + ": error against run time as the time step is halved, 1 thread", "run time (s)",
      std::string("error: ") + DifferenceNorm,
      "Are slices of 4-simplices worth their time between two time steps (" + field + ")?",
      "The region midway between time steps, by slices of 4-simplices and by interpolated values; "
      "labels are time steps. Values sampled at that time show the remaining spatial error. They "
      "are not available in practice and are excluded from the front. Ringed: slices at the "
      "shortest time step.");
    for (const BenchRow& row : rows)
    {
      for (const Method& method : Methods)
      {
        if (IsOf(row, field, method.Name))
        {
          plot.AddRow(row, row.Method != Slice);
        }
      }
    }
    plot.ExcludeFromFront(Sampled);
    plot.SetDefault(Slice);
    plots.push_back(plot);
  }
  return plots;
}
}

BenchPart MakeErrorPart()
{
  return { AddErrorRows, MakeErrorPlots, CheckErrorClaims };
}
}

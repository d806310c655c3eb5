// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/BenchParts.h"

#include "Benchmarks/Data/KeptTimeSteps.h"
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

/// A field at evenly spaced times, and at the times midway.
struct Film
{
  MovingField Field;
  vtkSmartPointer<KeptTimeSteps> Steps;
  vtkSmartPointer<KeptTimeSteps> Middles;

  Film(const MovingField& field, int slabs)
    : Field(field)
    , Steps(vtkSmartPointer<KeptTimeSteps>::New())
    , Middles(vtkSmartPointer<KeptTimeSteps>::New())
  {
    const double half = (MovingField::LastTime - MovingField::FirstTime) / (2 * slabs);
    field.Source->SetTimeRange(MovingField::FirstTime, MovingField::LastTime);
    field.Source->SetNumberOfTimeSteps(slabs + 1);
    this->Steps->AddStepsOf(field.Source);
    field.Source->SetTimeRange(MovingField::FirstTime + half, MovingField::LastTime - half);
    field.Source->SetNumberOfTimeSteps(slabs);
    this->Middles->AddStepsOf(field.Source);
  }

  int GetNumberOfSlabs() const { return this->Middles->GetNumberOfSteps(); }
};

Region IntervalVolume(const MovingField& field, vtkDataObject* image)
{
  auto filter =
    methods::NewIntervalVolume(vtkDataSet::SafeDownCast(image), field.Lower, field.Upper);
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  filter->Update();
  return filter->GetOutput();
}

vtkSmartPointer<vtkTimeVaryingIntervalVolume> NewSlab(const Film& film, int slab)
{
  auto filter =
    Case{ film.Field.Name, film.Steps, film.Field.Lower, film.Field.Upper, {} }.NewFilter();
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

Region MakeSlice(const Film& film, int slab)
{
  auto filter = NewSlab(film, slab);
  filter->Update();
  return SliceOf(filter->GetOutputDataObject(2), film.Middles->GetTimeOf(slab));
}

Region MakeInterpolated(const Film& film, int slab)
{
  auto* first = vtkImageData::SafeDownCast(film.Steps->GetStep(slab));
  auto* second = vtkImageData::SafeDownCast(film.Steps->GetStep(slab + 1));
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
  return IntervalVolume(film.Field, image);
}

Region MakeSampled(const Film& film, int slab)
{
  return IntervalVolume(film.Field, film.Middles->GetStep(slab));
}

struct Method
{
  const char* Name;
  Region (*Make)(const Film& film, int slab);
};

constexpr std::size_t NumberOfMethods = 3;
const Method Methods[NumberOfMethods] = { { Slice, MakeSlice }, { Interpolate, MakeInterpolated },
  { Sampled, MakeSampled } };

std::vector<BenchSeconds> TimeMethods(const Film& film, const BenchOptions& options)
{
  std::vector<BenchWork> works;
  for (const Method& method : Methods)
  {
    works.push_back(WithThreads(1,
      [&film, &method]()
      {
        vtkSmartPointer<vtkObjectBase> last;
        for (int slab = 0; slab < film.GetNumberOfSlabs(); ++slab)
        {
          last = method.Make(film, slab);
        }
        return last;
      }));
  }
  return MeasureAlternately(works, options.GetRepeats());
}

/// The mean error of a method over a film, and how many tetrahedra it made.
struct FilmError : RegionError
{
  vtkIdType Tetrahedra = 0;

  FilmError(const Film& film, const Method& method)
  {
    const int slabs = film.GetNumberOfSlabs();
    for (int slab = 0; slab < slabs; ++slab)
    {
      const Region region = method.Make(film, slab);
      const RegionError error = MeasureRegion(film.Field, film.Middles->GetTimeOf(slab), region);
      this->SymmetricDifference += error.SymmetricDifference / slabs;
      this->Volume += error.Volume / slabs;
      this->Tetrahedra += region->GetNumberOfCells();
    }
  }
};

void AddFilmRows(const Film& film, const Method& method, const BenchSeconds& seconds,
  const BenchSeconds& peerSeconds, std::vector<BenchRow>& found, const BenchRows& rows)
{
  const FilmError error(film, method);
  BenchRow row =
    rows.Make(film.Field.Name, method.Name, film.Steps->GetTimeOf(1) - film.Steps->GetTimeOf(0));
  row.Seconds = seconds;
  if (row.Method == Slice)
  {
    row.Peer = Interpolate;
    row.PeerSeconds = peerSeconds;
  }
  row.Set({ { "threads", 1 }, { "slabs", film.GetNumberOfSlabs() },
    { "cells", film.Steps->GetStep(0)->GetNumberOfElements(vtkDataObject::CELL) },
    { "tetrahedra", error.Tetrahedra } });
  row.SetError(DifferenceNorm, error.SymmetricDifference);
  found.push_back(row);
  row.SetError(VolumeNorm, error.Volume);
  found.push_back(row);
}

/// The rows of a field, method by method.
void AddFieldRows(const MovingField& field, const std::vector<int>& numbersOfSlabs,
  const BenchOptions& options, BenchRows& rows)
{
  std::array<std::vector<BenchRow>, NumberOfMethods> found;
  for (const int slabs : numbersOfSlabs)
  {
    const Film film(field, slabs);
    const std::vector<BenchSeconds> seconds = TimeMethods(film, options);
    for (std::size_t i = 0; i < NumberOfMethods; ++i)
    {
      AddFilmRows(film, Methods[i], seconds[i], seconds[1], found[i], rows);
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

void AddSliceAgainRow(const Film& film, const BenchOptions& options, BenchRows& rows)
{
  auto filter = NewSlab(film, 0);
  filter->Update();
  const auto simplices = vtkSmartPointer<vtkDataObject>(filter->GetOutputDataObject(2));
  const double time = film.Middles->GetTimeOf(0);
  const std::vector<BenchSeconds> seconds =
    MeasureAlternately({ WithThreads(1, [&]() { return SliceOf(simplices, time); }),
                         WithThreads(1, [&]() { return MakeInterpolated(film, 0); }) },
      options.GetRepeats());
  BenchRow row = rows.Make(film.Field.Name, SliceAgain);
  row.SetTimes(seconds[0], Interpolate, seconds[1]);
  row.Set(
    { { "threads", 1 }, { "4_simplices", simplices->GetNumberOfElements(vtkDataObject::CELL) } });
  rows.Add(row);
}

bool IsOf(const BenchRow& row, const std::string& field, const std::string& method)
{
  // Rounding alone has no order, and no place on a logarithmic axis.
  return row.Case == field && row.Method == method && row.ErrorNorm == DifferenceNorm &&
    *row.Error > 1e-12;
}

/// The error of `sampled` in the row like \a row, which no time step can be below.
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
 * The regions midway between every two of evenly spaced time steps, by one thread, warm. The
 * parameter is the time from step to step, which is halved. Methods:
 * - `slice`: vtkTimeVaryingIntervalVolume from step to step, then vtkSimplexTimeSlice;
 * - `interpolate`, the peer: the values of both steps averaged, then vtkIntervalVolume;
 * - `sampled`: the field itself at that time on the same grid, then vtkIntervalVolume (seconds
 *   without the sampling): the error that is left when time adds none.
 *
 * One row for each norm, each the mean over the regions:
 * - `symmetric difference, share of the volume`: with the analytic region, to first order: the
 *   distance of the result's surface from the analytic one, integrated over its area;
 * - `volume, relative`: of the volume of the analytic region.
 *
 * Rows with `order` in their counts: the exponent of the first norm against the time step, from the
 * errors that are more than four times that of `sampled`. Rows of method `slice-again`: one more
 * slice of 4-simplices that are there, against `interpolate` of one region.
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
    AddSliceAgainRow(Film(field, numbersOfSlabs.front()), options, rows);
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
      "Is a slice of 4-simplices worth its time between two steps (" + field + ")?",
      "The region midway between time steps: slices, interpolated values and, for the error that "
      "is left and as no choice, since nobody has them, values sampled then; by the time from step "
      "to step. Ringed: slices at the shortest step.");
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
    plot.SetNoChoice(Sampled);
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

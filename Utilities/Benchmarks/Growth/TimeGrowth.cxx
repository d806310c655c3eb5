// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Growth/GrowthQuantity.h"

#include "Benchmarks/Measures/TemporaryFolder.h"
#include "Benchmarks/SpaceTime/VortexShares.h"

#include "vtkAnalyticFieldSource.h"
#include "vtkTimeSlabWriter.h"
#include "vtkTimeVaryingIntervalVolume.h"

#include <memory>
#include <stdexcept>

namespace growth
{
namespace
{
constexpr double Lower = 0.0;
constexpr double Upper = 0.3;

/// The slabs between steps a unit of time apart. By symmetry each has as much to do.
vtkSmartPointer<vtkAnalyticFieldSource> MakeGyroid(int points, int slabs)
{
  auto source = vtkSmartPointer<vtkAnalyticFieldSource>::New();
  source->SetFieldToGyroid();
  source->SetDimensions(points, points, points);
  source->SetNumberOfTimeSteps(slabs + 1);
  source->SetTimeRange(0.0, slabs);
  return source;
}

interval4d::Case KeepGyroid(int points, int slabs)
{
  interval4d::Case made;
  made.Steps = vtkSmartPointer<KeptTimeSteps>::New();
  made.Steps->AddStepsOf(MakeGyroid(points, slabs));
  made.Lower = Lower;
  made.Upper = Upper;
  return made;
}

/// Counts the 4-simplices, unless \a n is given.
Job MakeJob(const interval4d::Case& what, std::optional<double> n)
{
  const auto simplices = std::make_shared<double>(0.0);
  Job job;
  job.Measured.Fresh = WithThreads(1,
    [what, simplices]()
    {
      auto filter = what.NewFilter();
      filter->Update();
      *simplices = static_cast<double>(filter->GetReport().Simplices);
      return vtkSmartPointer<vtkObjectBase>(filter->GetOutputDataObject(0));
    });
  job.GetN = [simplices, n]() { return n.value_or(*simplices); };
  for (int step = 0; step < what.Steps->GetNumberOfSteps(); ++step)
  {
    job.InputKib += static_cast<double>(what.Steps->GetStep(step)->GetActualMemorySize());
  }
  return job;
}

std::vector<int> GetSlabs(const BenchOptions& options)
{
  return options.Pick<std::vector<int>>({ 2, 4, 8, 16, 32 }, { 2, 4, 8, 16 }, { 1, 2, 4 });
}

int GetPointsOfSlabs(const BenchOptions& options)
{
  return options.Pick(21, 17, 9);
}

Job MakeWriterJob(int points, int slabs)
{
  const auto folder = std::make_shared<TemporaryFolder>("interlume-bench-growth");
  Job job;
  job.Measured.Fresh = WithThreads(1,
    [folder, points, slabs]()
    {
      folder->Clear();
      auto writer = vtkSmartPointer<vtkTimeSlabWriter>::New();
      writer->SetInputConnection(MakeGyroid(points, slabs)->GetOutputPort());
      writer->SetNumberOfIntervals(1);
      writer->SetInterval(0, Lower, Upper);
      writer->SetFileName((folder->Path / "slabs.vtm").string().c_str());
      if (!writer->Write() || writer->GetNumberOfWrittenSlabs() != slabs)
      {
        throw std::runtime_error("slabs cannot be written to " + folder->Path.string());
      }
      return vtkSmartPointer<vtkObjectBase>(writer);
    });
  job.GetN = [slabs]() { return slabs; };
  return job;
}
}

Quantity MakeSimplices(const BenchOptions& options)
{
  return { "4-simplices", "4-simplices",
    "vtkTimeVaryingIntervalVolume of two steps of the field VORTEX on one grid, the interval "
    "growing, 1 thread",
    options.Pick<std::vector<int>>({ 10, 20, 40, 80, 160 }, { 10, 20, 40, 80, 160 }, { 20, 60 }),
    { 1.0, 1.0,
      "each 4-simplex is projected and cut by itself; classifying the cells is a constant that is "
      "less" },
    { 1.0, 1.0, "the tetrahedra of each 4-simplex are in the output" },
    [](int thousandths, const BenchOptions& sizes)
    {
      interval4d::VortexShares vortex(sizes.Pick(65, 33, 13));
      vortex.SetShare(0.001 * thousandths);
      return MakeJob(vortex.Get(), std::nullopt);
    } };
}

Quantity MakeCellsInTime(const BenchOptions& options)
{
  return { "cells in time", "cells",
    "vtkTimeVaryingIntervalVolume of two steps of a gyroid, the interval the same at every "
    "resolution, 1 thread",
    options.Pick<std::vector<int>>({ 17, 25, 33, 49, 65 }, { 9, 13, 17, 25 }, { 7, 9, 13 }),
    { 2.0 / 3.0, 1.0,
      "N to classify the cells and to fill the inside, N^(2/3) at the surfaces, where a cell has "
      "most 4-simplices; N dominates in the end" },
    { 2.0 / 3.0, 1.0,
      "4-simplices fill a constant share of space and time, N, and N^(2/3) more are at the "
      "surfaces" },
    [](int points, const BenchOptions&)
    {
      const interval4d::Case gyroid = KeepGyroid(points, 1);
      return MakeJob(gyroid, static_cast<double>(gyroid.GetNumberOfCells()));
    } };
}

Quantity MakeSteps(const BenchOptions& options)
{
  return { "time steps", "slabs between time steps",
    "vtkTimeVaryingIntervalVolume of a gyroid that moves, all slabs in one output, steps in "
    "memory, 1 thread",
    GetSlabs(options), { 1.0, 1.0, "each slab is extracted by itself, and has as much in it" },
    { 1.0, 1.0, "the output holds every slab; of the steps, two are at work" },
    [](int slabs, const BenchOptions& sizes)
    { return MakeJob(KeepGyroid(GetPointsOfSlabs(sizes), slabs), slabs); } };
}

Quantity MakeWrittenSteps(const BenchOptions& options)
{
  return { "time steps, written slab by slab", "slabs between time steps",
    "vtkTimeSlabWriter of the same slabs, each step made when it is asked for and in the memory "
    "that is measured, 1 thread",
    GetSlabs(options), { 1.0, 1.0, "each slab is extracted and written by itself" },
    { 0.0, 0.0, "two steps and one slab are held at a time" },
    [](int slabs, const BenchOptions& sizes)
    { return MakeWriterJob(GetPointsOfSlabs(sizes), slabs); } };
}
}

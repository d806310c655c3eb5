// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Growth/Growth.h"

#include "Benchmarks/Data/BenchData.h"
#include "Benchmarks/Intervals/ExtractionMethods.h"
#include "Benchmarks/Measures/TemporaryFolder.h"
#include "Benchmarks/SpaceTime/VortexShares.h"

#include "vtkAnalyticFieldSource.h"
#include "vtkAnalyticFlowSource.h"
#include "vtkImplicitFlowField.h"
#include "vtkTimeSlabWriter.h"
#include "vtkTimeVaryingIntervalVolume.h"

#include "vtkImageData.h"
#include "vtkNew.h"

#include <memory>
#include <stdexcept>

namespace growth
{
namespace
{
/// Extracts from a wavelet, which has the same waves at every size.
Job MakeWaveletJob(
  int points, const std::function<vtkSmartPointer<vtkObjectBase>(const BenchData&)>& method)
{
  const BenchData data = MakeWavelet(points);
  Job job;
  job.Work = WithThreads(1, [data, method]() { return method(data); });
  job.GetN = [data]() { return static_cast<double>(data.Data->GetNumberOfCells()); };
  job.InputKib = static_cast<double>(data.Data->GetActualMemorySize());
  return job;
}

std::vector<int> GetPoints(const BenchOptions& options)
{
  return options.Pick<std::vector<int>>({ 33, 49, 65, 97, 129 }, { 17, 25, 33, 49 }, { 9, 13, 17 });
}

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

/// N counts the 4-simplices, unless \a n is given.
Job MakeTimeJob(const interval4d::Case& what, std::optional<double> n)
{
  const auto simplices = std::make_shared<double>(0.0);
  Job job;
  job.Work = WithThreads(1,
    [what, simplices]()
    {
      auto filter = what.NewFilter();
      filter->Update();
      *simplices = filter->GetReport()->GetNumber("Simplices");
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
  job.Work = WithThreads(1,
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

Job MakeFlowJob(int samples, const BenchOptions& options)
{
  vtkNew<vtkAnalyticFlowSource> source;
  const int points = options.Pick(33, 17, 9);
  source->SetField(vtkAnalyticFlowSource::HURRICANE);
  source->SetDimensions(points, points, points);
  source->Update();
  vtkSmartPointer<vtkImageData> field = source->GetOutput();
  Job job;
  job.Work = WithThreads(options.Threads,
    [field, samples]()
    {
      vtkNew<vtkImplicitFlowField> filter;
      filter->SetInputData(field);
      filter->DomainFacesOn();
      filter->SetMaximumTime(2.0);
      filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
      filter->SetSampleDimensions(samples, samples, samples);
      filter->Update();
      return vtkSmartPointer<vtkObjectBase>(filter->GetOutputDataObject(0));
    });
  job.GetN = [samples]() { return static_cast<double>(samples) * samples * samples; };
  job.InputKib = static_cast<double>(field->GetActualMemorySize());
  return job;
}

Quantity MakeCells(const BenchOptions& options)
{
  return { "cells", GetPoints(options),
    { 2.0 / 3.0, 1.0,
      "N to classify the cells and to fill the inside, N^(2/3) at the surfaces, where a cell takes "
      "most; N dominates in the end" },
    { 2.0 / 3.0, 1.0,
      "tetrahedra fill a constant share of the volume, N, and N^(2/3) more are at the surfaces" },
    [](int points, const BenchOptions&)
    {
      return MakeWaveletJob(points,
        [](const BenchData& data)
        { return methods::IntervalVolume(data.Data, data.Lower, data.Upper); });
    } };
}

Quantity MakeContour(const BenchOptions& options)
{
  return { "cells of a contour", GetPoints(options),
    { 2.0 / 3.0, 1.0,
      "N to classify the cells, N^(2/3) to make the triangles of those that the surface meets: "
      "which dominates depends on the size" },
    { 2.0 / 3.0, 2.0 / 3.0, "the surface meets N^(2/3) cells" },
    [](int points, const BenchOptions&)
    {
      return MakeWaveletJob(points,
        [](const BenchData& data)
        { return methods::IsotableContour(data.Data, data.Lower, true); });
    } };
}

Quantity MakeSimplices(const BenchOptions& options)
{
  return { "4-simplices",
    options.Pick<std::vector<int>>({ 10, 20, 40, 80, 160 }, { 10, 20, 40, 80, 160 }, { 20, 60 }),
    { 1.0, 1.0,
      "each 4-simplex is projected and cut by itself; classifying the cells is a constant that is "
      "less" },
    { 1.0, 1.0, "the tetrahedra of each 4-simplex are in the output" },
    [](int thousandths, const BenchOptions& sizes)
    {
      interval4d::VortexShares vortex(sizes.Pick(65, 33, 13));
      vortex.SetShare(0.001 * thousandths);
      return MakeTimeJob(vortex.Get(), std::nullopt);
    } };
}

Quantity MakeSteps(const BenchOptions& options)
{
  return { "time steps", GetSlabs(options),
    { 1.0, 1.0, "each slab is extracted by itself, and has as much in it" },
    { 1.0, 1.0, "the output holds every slab; of the steps, two are at work" },
    [](int slabs, const BenchOptions& sizes)
    { return MakeTimeJob(KeepGyroid(GetPointsOfSlabs(sizes), slabs), slabs); } };
}

Quantity MakeWrittenSteps(const BenchOptions& options)
{
  return { "time steps, written slab by slab", GetSlabs(options),
    { 1.0, 1.0, "each slab is extracted and written by itself" },
    { 0.0, 0.0, "two steps and one slab are held at a time" },
    [](int slabs, const BenchOptions& sizes)
    { return MakeWriterJob(GetPointsOfSlabs(sizes), slabs); } };
}

Quantity MakeSamples(const BenchOptions& options)
{
  return { "samples",
    options.Pick<std::vector<int>>({ 24, 32, 48, 64, 80 }, { 16, 24, 32, 48 }, { 5, 7, 9 }),
    { 1.0, 1.0, "each sample has a streamline of its own, of the same mean length" },
    { 1.0, 1.0, "each sample has its answer in the output" }, MakeFlowJob };
}
}

std::vector<Quantity> MakeQuantities(const BenchOptions& options)
{
  return { MakeCells(options), MakeContour(options), MakeSimplices(options), MakeSteps(options),
    MakeWrittenSteps(options), MakeSamples(options) };
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Growth/Growth.h"

#include "Benchmarks/Data/BenchData.h"
#include "Benchmarks/Intervals/ExtractionMethods.h"
#include "Benchmarks/Measures/TemporaryFolder.h"
#include "Benchmarks/SpaceTime/VortexFractions.h"

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
/// Returns a job that applies \a method to a wavelet. The waves are the same at every resolution.
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

/// Returns a moving gyroid with one time step per unit of time. By symmetry, all time slabs require
/// the same work.
vtkSmartPointer<vtkAnalyticFieldSource> MakeGyroid(int points, int slabs)
{
  auto source = vtkSmartPointer<vtkAnalyticFieldSource>::New();
  source->SetFieldToGyroid();
  source->SetDimensions(points, points, points);
  source->SetNumberOfTimeSteps(slabs + 1);
  source->SetTimeRange(0.0, slabs);
  return source;
}

interval4d::Case MakeGyroidCase(int points, int slabs)
{
  interval4d::Case made;
  made.Steps = vtkSmartPointer<StoredTimeSteps>::New();
  made.Steps->AddStepsFrom(MakeGyroid(points, slabs));
  made.Lower = Lower;
  made.Upper = Upper;
  return made;
}

/// Returns a job whose N is \a n or, if \a n is empty, the number of 4-simplices.
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
        throw std::runtime_error("Cannot write time slabs to " + folder->Path.string());
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
      "N to classify the cells and to fill the interior, N^(2/3) at the surfaces, where cells cost "
      "most; N dominates for large N" },
    { 2.0 / 3.0, 1.0,
      "tetrahedra fill a constant fraction of the volume, N, plus N^(2/3) at the surfaces" },
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
      "N to classify the cells, N^(2/3) to create triangles in cells that the surface intersects; "
      "the size determines which dominates" },
    { 2.0 / 3.0, 2.0 / 3.0, "the surface intersects N^(2/3) cells" },
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
      "each 4-simplex is projected and split separately; classifying the cells is a smaller "
      "constant" },
    { 1.0, 1.0, "the output contains the tetrahedra of each 4-simplex" },
    [](int thousandths, const BenchOptions& sizes)
    {
      interval4d::VortexFractions vortex(sizes.Pick(65, 33, 13));
      vortex.SetFraction(0.001 * thousandths);
      return MakeTimeJob(vortex.Get(), std::nullopt);
    } };
}

Quantity MakeSteps(const BenchOptions& options)
{
  return { "time steps", GetSlabs(options),
    { 1.0, 1.0, "each slab is extracted separately and requires the same work" },
    { 1.0, 1.0, "the output contains all slabs; the filter works on two steps at a time" },
    [](int slabs, const BenchOptions& sizes)
    { return MakeTimeJob(MakeGyroidCase(GetPointsOfSlabs(sizes), slabs), slabs); } };
}

Quantity MakeWrittenSteps(const BenchOptions& options)
{
  return { "time steps, written slab by slab", GetSlabs(options),
    { 1.0, 1.0, "each slab is extracted and written separately" },
    { 0.0, 0.0, "two steps and one slab are in memory at a time" },
    [](int slabs, const BenchOptions& sizes)
    { return MakeWriterJob(GetPointsOfSlabs(sizes), slabs); } };
}

Quantity MakeSamples(const BenchOptions& options)
{
  return { "samples",
    options.Pick<std::vector<int>>({ 24, 32, 48, 64, 80 }, { 16, 24, 32, 48 }, { 5, 7, 9 }),
    { 1.0, 1.0, "each sample has its own streamline, of the same mean length" },
    { 1.0, 1.0, "the output contains one result per sample" }, MakeFlowJob };
}
}

std::vector<Quantity> MakeQuantities(const BenchOptions& options)
{
  return { MakeCells(options), MakeContour(options), MakeSimplices(options), MakeSteps(options),
    MakeWrittenSteps(options), MakeSamples(options) };
}
}

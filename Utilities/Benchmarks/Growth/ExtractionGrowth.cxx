// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Growth/GrowthQuantity.h"

#include "Benchmarks/Data/BenchData.h"
#include "Benchmarks/Intervals/ExtractionMethods.h"

#include <algorithm>

namespace growth
{
namespace
{
using Method = std::function<vtkSmartPointer<vtkObjectBase>(const BenchData&)>;

vtkSmartPointer<vtkObjectBase> ExtractVolume(const BenchData& data)
{
  return methods::IntervalVolume(data.Data, data.Lower, data.Upper);
}

Job MakeJob(const BenchData& data, int threads, const Method& method)
{
  Job job;
  job.Measured.Fresh = WithThreads(threads, [data, method]() { return method(data); });
  job.GetN = [data]() { return static_cast<double>(data.Data->GetNumberOfCells()); };
  job.InputKib = static_cast<double>(data.Data->GetActualMemorySize());
  return job;
}

std::vector<int> GetPoints(const BenchOptions& options)
{
  return options.Pick<std::vector<int>>({ 33, 49, 65, 97, 129 }, { 17, 25, 33, 49 }, { 9, 13, 17 });
}
}

Quantity MakeCells(const BenchOptions& options)
{
  return { "cells", "cells",
    "vtkIntervalVolume of a wavelet, the interval the same at every resolution, 1 thread",
    GetPoints(options),
    { 2.0 / 3.0, 1.0,
      "N to classify the cells and to fill the inside, N^(2/3) at the surfaces, where a cell takes "
      "most; N dominates in the end" },
    { 2.0 / 3.0, 1.0,
      "tetrahedra fill a constant share of the volume, N, and N^(2/3) more are at the surfaces" },
    [](int points, const BenchOptions&)
    { return MakeJob(MakeWavelet(points), 1, ExtractVolume); } };
}

Quantity MakeContour(const BenchOptions& options)
{
  return { "cells of a contour", "cells", "vtkIsotableContour of one value of a wavelet, 1 thread",
    GetPoints(options),
    { 2.0 / 3.0, 1.0,
      "N to classify the cells, N^(2/3) to make the triangles of those that the surface meets: "
      "which dominates depends on the size" },
    { 2.0 / 3.0, 2.0 / 3.0, "the surface meets N^(2/3) cells" },
    [](int points, const BenchOptions&)
    {
      return MakeJob(MakeWavelet(points), 1,
        [](const BenchData& data)
        { return methods::IsotableContour(data.Data, data.Lower, true); });
    } };
}

Quantity MakeThreads(const BenchOptions& options)
{
  Quantity made;
  made.Name = "threads";
  made.Counted = "threads";
  made.Work = "vtkIntervalVolume of the largest wavelet but one";
  // No more than there are: TBB ignores the others.
  for (int threads = 1; threads <= std::max(2, options.Threads); threads *= 2)
  {
    made.Sizes.push_back(threads);
  }
  made.Memory = { 0.0, 0.0, "the output is the same, and each thread's own buffers are a part" };
  made.Time = { 0.0, 0.0, "no thread does the work of another again" };
  const std::vector<int> points = GetPoints(options);
  made.Make = [points = points[points.size() - 2]](int threads, const BenchOptions&)
  {
    Job job = MakeJob(MakeWavelet(points), threads, ExtractVolume);
    job.GetN = [threads]() { return threads; };
    return job;
  };
  return made;
}
}

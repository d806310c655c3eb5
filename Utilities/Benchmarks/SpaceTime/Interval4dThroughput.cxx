// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/BenchParts.h"

#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/SpaceTime/VortexFractions.h"

#include "vtkTimeVaryingIntervalVolume.h"

#include <string>

namespace interval4d
{
namespace
{
void AddRow(const Case& what, double fraction, const BenchOptions& options, BenchRows& rows)
{
  vtkIdType simplices = 0;
  const BenchWork work = [&]()
  {
    auto filter = what.NewFilter();
    filter->Update();
    simplices = filter->GetReport()->GetCount("Simplices");
    return vtkSmartPointer<vtkObjectBase>(filter->GetOutputDataObject(0));
  };
  BenchRow row = rows.Make(what.Name, "throughput", fraction);
  row.Seconds = MeasureAlternately({ WithThreads(1, work) }, options.GetRepeats()).front();
  row.Set(
    { { "cells", what.GetNumberOfCells() }, { "lower", what.Lower }, { "simplices", simplices },
      { "simplices_per_second", static_cast<double>(simplices) / *row.Seconds } });
  rows.Add(row);
}

/**
 * Adds rows of method `throughput`, with one thread and a filled case table. They measure the
 * extraction of f >= c from the field VORTEX on grids of several resolutions. The parameter is the
 * fraction of grid points that are inside at time 0. It determines c.
 */
void AddThroughputRows(const BenchOptions& options, BenchRows& rows)
{
  const auto sizes = options.Pick<std::vector<int>>({ 32, 64, 96, 128 }, { 32, 64 }, { 12, 16 });
  const auto fractions = options.Pick<std::vector<double>>(
    { 0.00001, 0.0001, 0.001, 0.01, 0.03 }, { 0.0001, 0.001, 0.01, 0.03 }, { 0.01, 0.03 });
  for (const int points : sizes)
  {
    VortexFractions vortex(points);
    for (const double fraction : fractions)
    {
      if (vortex.SetFraction(fraction))
      {
        AddRow(vortex.Get(), fraction, options, rows);
      }
    }
  }
}

std::vector<BenchPlot> MakeThroughputPlots(const std::vector<BenchRow>& rows)
{
  BenchPlot plot = BenchPlot::OfErrors("interval4d-throughput",
    "4-simplices, projected and cut into tetrahedra, 1 thread", "4-simplices",
    "4-simplices a second");
  plot.HasFront = false;
  for (const BenchRow& row : rows)
  {
    if (row.Method == "throughput" && row.Counts["simplices"].get<double>() > 0.0)
    {
      plot.AddPoint(row.Case, false, row.Counts["simplices"].get<double>(),
        row.Counts["simplices_per_second"].get<double>());
    }
  }
  return { plot };
}
}

BenchPart MakeThroughputPart()
{
  return { AddThroughputRows, MakeThroughputPlots };
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/BenchParts.h"

#include "Benchmarks/Data/BenchData.h"
#include "Benchmarks/Intervals/ExtractionMethods.h"
#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Measures/SecondThread.h"
#include "Benchmarks/Results/SpeedPlots.h"

namespace interval
{
namespace
{
void AddRowsOf(const BenchData& data, int threads, const BenchOptions& options, BenchRows& rows)
{
  vtkIdType tetrahedra = 0;
  vtkIdType mixedCells = 0;
  vtkIdType baselineTetrahedra = 0;
  const BenchWork ours = [&]()
  {
    auto grid = methods::IntervalVolume(data.Data, data.Lower, data.Upper);
    tetrahedra = grid->GetNumberOfCells();
    return grid;
  };
  const BenchWork clip2 = [&]()
  {
    auto grid =
      methods::ClipTwice(data.Data, data.Lower, data.Upper, vtkAlgorithm::DEFAULT_PRECISION);
    mixedCells = grid->GetNumberOfCells();
    return grid;
  };
  const BenchWork clip2Tetrahedra = [&]()
  {
    auto grid = methods::ToTetrahedra(
      methods::ClipTwice(data.Data, data.Lower, data.Upper, vtkAlgorithm::DEFAULT_PRECISION));
    baselineTetrahedra = grid->GetNumberOfCells();
    return grid;
  };
  const std::vector<BenchSeconds> seconds =
    MeasureAlternately({ WithThreads(threads, ours), WithThreads(threads, clip2),
                         WithThreads(threads, clip2Tetrahedra) },
      options.GetRepeats());

  BenchRow row = rows.Make(data.Case, "interval-volume", ThreadsParameter(threads));
  row.Seconds = seconds[0];
  row.Set({ { "threads", threads }, { "cells", data.Data->GetNumberOfCells() },
    { "tetrahedra", tetrahedra } });
  BenchRow againstClip = row;
  againstClip.Baseline = "clip2";
  againstClip.BaselineSeconds = seconds[1];
  againstClip.Counts["peer_cells"] = mixedCells;
  rows.Add(againstClip);
  BenchRow againstTetrahedra = row;
  againstTetrahedra.Baseline = "clip2-tetrahedra";
  againstTetrahedra.BaselineSeconds = seconds[2];
  againstTetrahedra.Counts["peer_cells"] = baselineTetrahedra;
  rows.Add(againstTetrahedra);
}

/**
 * Measures the method `interval-volume`, with the baselines `clip2` and `clip2-tetrahedra`, with
 * one thread and with all threads.
 */
void AddSpeedRows(const BenchOptions& options, BenchRows& rows)
{
  for (const BenchData& data : MakeSpeedCases(options))
  {
    for (int threads : options.GetThreadCounts())
    {
      AddRowsOf(data, threads, options, rows);
    }
  }
}

/**
 * Measures extraction with two threads (method `threads-2`) and with one thread (baseline
 * `threads-1`).
 */
void AddThreadRows(const BenchOptions& options, BenchRows& rows)
{
  for (const BenchData& data : MakeSpeedCases(options))
  {
    const BenchWork work = [&data]()
    { return methods::IntervalVolume(data.Data, data.Lower, data.Upper); };
    BenchRow row = rows.Make(data.Case, "threads-2");
    row.Counts["cells"] = data.Data->GetNumberOfCells();
    MeasureTwoThreads(work, options, row);
    rows.Add(row);
  }
}
}

BenchPart MakeSpeedPart()
{
  const auto check = [](const std::vector<BenchRow>& rows) -> std::vector<BenchClaim>
  {
    return { BenchClaim::AtLeast("1 thread, at least 3 times faster than clip2", 3.0, rows,
               RatioWithOneThread("interval-volume", "clip2")),
      BenchClaim::AtLeast("1 thread, at least 40 times faster than clip2-tetrahedra", 40.0, rows,
        RatioWithOneThread("interval-volume", "clip2-tetrahedra")),
      BenchClaim::AtLeast("a second thread gives at least 1.7", 1.7, rows, RatioOf("threads-2")) };
  };
  const auto plot = [](const std::vector<BenchRow>& rows)
  { return MakeRatioPlots("interval", "interval-volume", rows); };
  return { [](const BenchOptions& options, BenchRows& rows)
    {
      AddSpeedRows(options, rows);
      AddThreadRows(options, rows);
    },
    plot, check };
}
}

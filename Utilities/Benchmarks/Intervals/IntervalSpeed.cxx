// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Intervals/IntervalParts.h"

#include "Benchmarks/Data/BenchData.h"
#include "Benchmarks/Intervals/ExtractionMethods.h"
#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Measures/SecondThread.h"
#include "Benchmarks/Results/SpeedPlots.h"

#include "vtkIntervalVolume.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <array>
#include <string>

namespace interval
{
namespace
{
void AddRowsOf(const BenchData& data, int threads, const BenchOptions& options, BenchRows& rows)
{
  vtkIdType tetrahedra = 0;
  vtkIdType mixedCells = 0;
  vtkIdType peerTetrahedra = 0;
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
    peerTetrahedra = grid->GetNumberOfCells();
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
  againstClip.Peer = "clip2";
  againstClip.PeerSeconds = seconds[1];
  againstClip.Counts["peer_cells"] = mixedCells;
  rows.Add(againstClip);
  BenchRow againstTetrahedra = row;
  againstTetrahedra.Peer = "clip2-tetrahedra";
  againstTetrahedra.PeerSeconds = seconds[2];
  againstTetrahedra.Counts["peer_cells"] = peerTetrahedra;
  rows.Add(againstTetrahedra);
}

/// A row for an interval in the middle or at the end of the range of values.
void AddReExtractionRow(const BenchData& data, const std::string& place,
  const std::array<double, 2>& bounds, double width, const BenchOptions& options, BenchRows& rows)
{
  auto indexed = methods::NewIntervalVolume(data.Data, bounds[0], bounds[1]);
  auto plain = methods::NewIntervalVolume(data.Data, bounds[0], bounds[1]);
  plain->UseValueIndexOff();
  indexed->Update();

  // Every run has another interval, as when a slider is dragged.
  int run = 0;
  auto changed = [&](vtkIntervalVolume* filter)
  {
    const double shift = 0.005 * (++run % 5) * (bounds[1] - bounds[0]);
    filter->SetInterval(0, bounds[0] - shift, bounds[1] - shift);
    filter->Update();
    return vtkSmartPointer<vtkObjectBase>(filter->GetOutput());
  };
  const std::vector<BenchSeconds> seconds =
    MeasureAlternately({ WithThreads(1, [&]() { return changed(indexed); }),
                         WithThreads(1, [&]() { return changed(plain); }) },
      options.GetRepeats());

  const vtkExtractionReport& report = indexed->GetReport();
  BenchRow row = rows.Make(data.Case + "-" + place, "re-extract", width);
  row.SetTimes(seconds[0], "all-cells", seconds[1]);
  row.Set({ { "threads", 1 }, { "cells", report.Cells }, { "visited", report.CellsVisited },
    { "with_output", report.CellsWithOutput },
    { "share",
      static_cast<double>(report.CellsWithOutput) /
        static_cast<double>(data.Data->GetNumberOfCells()) } });
  rows.Add(row);
}

/**
 * Method `interval-volume`: against `clip2` and `clip2-tetrahedra`, by one thread and by all.
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
 * Method `threads-2`: two threads against the peer `threads-1`.
 */
void AddThreadRows(const BenchOptions& options, BenchRows& rows)
{
  for (const BenchData& data : MakeSpeedCases(options))
  {
    const BenchWork work = [&data]()
    { return methods::IntervalVolume(data.Data, data.Lower, data.Upper); };
    BenchRow row = rows.Make(data.Case, "threads-2");
    row.Counts["cells"] = data.Data->GetNumberOfCells();
    MeasureSecondThread(work, options, row);
    rows.Add(row);
  }
}

/**
 * Method `re-extract`: changed intervals with the value index, against the peer `all-cells` without
 * it, by one thread. The parameter is the width of the interval as a share of the range of values.
 */
void AddReExtractionRows(const BenchOptions& options, BenchRows& rows)
{
  const BenchData data = MakeWavelet(WaveletPoints(options));
  double range[2];
  data.Data->GetPointData()->GetScalars()->GetRange(range);
  const double length = range[1] - range[0];
  for (double width : { 0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 0.9 })
  {
    AddReExtractionRow(data, "end", { range[1] - width * length, range[1] }, width, options, rows);
  }
  for (double width : { 0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 0.9 })
  {
    const double middle = 0.5 * (range[0] + range[1]);
    AddReExtractionRow(data, "middle",
      { middle - 0.5 * width * length, middle + 0.5 * width * length }, width, options, rows);
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
  {
    std::vector<BenchPlot> plots = MakeRatioPlots("interval", "interval-volume", rows);
    const std::vector<BenchPlot> changed = MakeReExtractionPlots("interval", rows);
    plots.insert(plots.end(), changed.begin(), changed.end());
    return plots;
  };
  return { [](const BenchOptions& options, BenchRows& rows)
    {
      AddSpeedRows(options, rows);
      AddThreadRows(options, rows);
      AddReExtractionRows(options, rows);
    },
    plot, check };
}
}

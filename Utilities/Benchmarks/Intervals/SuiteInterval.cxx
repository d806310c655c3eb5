// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Data/BenchData.h"
#include "Benchmarks/Intervals/IntervalDrag.h"
#include "Benchmarks/Intervals/IntervalError.h"
#include "Benchmarks/Intervals/IntervalMemory.h"
#include "Benchmarks/Intervals/IntervalOrientation.h"
#include "Benchmarks/Intervals/IntervalSpeed.h"
#include "Benchmarks/Intervals/IntervalWhole.h"
#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Results/SpeedPlots.h"
#include "Benchmarks/Suites/BenchSuites.h"

#include "vtkCellType.h"

namespace
{
const char* const MemoryTask = "memory";
const char* const HexahedraTask = "memory-hexahedra";
const char* const FirstUseTask = "first-use";
const char* const WholeTask = "memory-whole";
const char* const Cold = "cold";

class SuiteInterval : public BenchSuite
{
public:
  std::string GetName() const override { return "interval"; }
  std::string GetTitle() const override
  {
    return "vtkIntervalVolume: run time, memory, orientation, error against run time";
  }
  std::vector<std::string> GetDescription() const override;
  void Run(const BenchOptions& options, BenchRows& rows) const override;
  std::vector<BenchPlot> MakePlots(const std::vector<BenchRow>& rows) const override;
  std::vector<BenchClaim> CheckClaims(const std::vector<BenchRow>& rows) const override;
  nlohmann::ordered_json RunTask(
    const std::string& task, const BenchOptions& options) const override;

private:
  void AddMemoryRows(const BenchOptions& options, BenchRows& rows) const;
  void AddFirstUseRows(const BenchOptions& options, BenchRows& rows) const;
};

std::vector<std::string> SuiteInterval::GetDescription() const
{
  return {
    "interval-volume: tetrahedra of vtkIntervalVolume, made anew each time, against clip2, two "
    "passes of vtkTableBasedClipDataSet, which give mixed cells, and clip2-tetrahedra, which makes "
    "them tetrahedra by vtkDataSetTriangleFilter. Each dataset has one point array.",
    "threads-2: the same extraction by two threads against one.",
    "re-extract: an interval that changes from run to run, as with a slider, with the index of "
    "value ranges against a pass over all cells, in the middle of the range of values, where it "
    "passes through most of the domain, and at its end. The parameter is the interval's width as a "
    "share of the range of values; share is the share of cells with output.",
    "drag, drag-tied: the lower bound of an interval up to the end of the range goes on by a two "
    "hundredth of the range, low, in the middle and high in it, with KeepMemory, against without "
    "(new-memory) and against a copy of as many bytes as the output has, between memory that is "
    "there (copy). Bounds equal no value of the data, or, drag-tied, are whole numbers, as the "
    "data "
    "are. changed is the number of cells that the bound passes through between two updates, share "
    "their share.",
    "whole-cells: the same with KeepWholeCells, against without (tetrahedra) and against clip2, "
    "which "
    "keeps whole cells too; output_kib is the size of the output, growth_kib by how much the "
    "resident memory of a process of its own grew at most.",
    "memory: in a process of its own; peak_kib is the input and the largest growth of resident "
    "memory; peak_share is the growth divided by the output; first_use_kib, which the tables and "
    "the code took before, is not in it.",
    "cold: the first extraction in a fresh process, where tables are still to be filled, against "
    "the second (peer warm).",
    "inverted: tetrahedra of negative volume; the error is the share of volume that they hold.",
    "hexahedra, hexahedra-unstructured, tetrahedra-5, -6, -24, clip2: error against run time on "
    "analytic fields, for the grid as it is, as unstructured hexahedra, split beforehand into "
    "tetrahedra (seconds without the split), and clipped twice. The reference is the exact region "
    "of "
    "the trilinear interpolant of the grid's values."
  };
}

void SuiteInterval::Run(const BenchOptions& options, BenchRows& rows) const
{
  interval::AddSpeedRows(options, rows);
  interval::AddThreadRows(options, rows);
  interval::AddReExtractionRows(options, rows);
  interval::AddDragRows(options, rows);
  interval::AddWholeRows(
    options,
    [&](const std::string& task)
    { return this->RunChild(std::string(WholeTask) + " " + task, options); },
    rows);
  this->AddMemoryRows(options, rows);
  this->AddFirstUseRows(options, rows);
  interval::AddOrientationRows(options, rows);
  interval::AddErrorRows(options, rows);
}

void SuiteInterval::AddMemoryRows(const BenchOptions& options, BenchRows& rows) const
{
  for (const BenchData& data : MakeSpeedCases(options))
  {
    const bool isGrid = data.Data->IsA("vtkUnstructuredGrid");
    for (const char* task : { MemoryTask, HexahedraTask })
    {
      if (isGrid && task == HexahedraTask)
      {
        continue;
      }
      BenchRow row = rows.Make(data.Case, "memory");
      row.Parameter = isGrid || task == HexahedraTask ? "unstructured" : "structured";
      row.Counts = this->RunChild(std::string(task) + " " + data.Case, options);
      if (row.Counts.contains("peak_kib"))
      {
        const double growth =
          row.Counts["peak_kib"].get<double>() - row.Counts["input_kib"].get<double>();
        row.Counts["peak_share"] = growth / row.Counts["output_kib"].get<double>();
      }
      rows.Add(row);
    }
  }
}

void SuiteInterval::AddFirstUseRows(const BenchOptions& options, BenchRows& rows) const
{
  for (int type : { VTK_TETRA, VTK_PYRAMID, VTK_WEDGE, VTK_HEXAHEDRON })
  {
    std::vector<double> cold;
    std::vector<double> warm;
    for (int repeat = 0; repeat < options.GetRepeats(); ++repeat)
    {
      const nlohmann::ordered_json seconds =
        this->RunChild(std::string(FirstUseTask) + " " + std::to_string(type), options);
      cold.push_back(seconds.at("cold"));
      warm.push_back(seconds.at("warm"));
    }
    BenchRow row = rows.Make(MakeRandomCells(type, 0, options.Seed).Case, Cold);
    row.Seconds = MedianOf(cold);
    row.Peer = "warm";
    row.PeerSeconds = MedianOf(warm);
    rows.Add(row);
  }
}

nlohmann::ordered_json SuiteInterval::RunTask(
  const std::string& task, const BenchOptions& options) const
{
  const std::size_t space = task.find(' ');
  const std::string name = task.substr(0, space);
  const std::string argument = space == std::string::npos ? "" : task.substr(space + 1);
  if (name == MemoryTask || name == HexahedraTask)
  {
    return interval::MeasureMemory(argument, name == HexahedraTask, options);
  }
  if (name == FirstUseTask)
  {
    return interval::MeasureFirstUse(std::stoi(argument), options);
  }
  if (name == WholeTask)
  {
    return interval::MeasureWholeMemory(argument, options);
  }
  return this->BenchSuite::RunTask(task, options);
}

std::vector<BenchClaim> SuiteInterval::CheckClaims(const std::vector<BenchRow>& rows) const
{
  auto secondThread = [](const BenchRow& row)
  { return row.Method == "threads-2" ? row.GetRatio() : std::nullopt; };
  auto dragged = [](const BenchRow& row)
  {
    const bool counts = row.Method.rfind("drag", 0) == 0 && row.Peer == "copy" &&
      row.Counts.value("threads", 1) > 1 && row.Counts.value("share", 1.0) < 0.1;
    return counts ? std::optional<double>(*row.Seconds) : std::nullopt;
  };
  const auto ofFirstUse = [](const BenchRow& row)
  {
    return row.Method == Cold ? std::optional<double>(*row.Seconds - *row.PeerSeconds)
                              : std::nullopt;
  };
  return { BenchClaim::AtLeast("1 thread, at least 3 times faster than clip2", 3.0, rows,
             RatioWithOneThread("interval-volume", "clip2")),
    BenchClaim::AtLeast("1 thread, at least 40 times faster than clip2-tetrahedra", 40.0, rows,
      RatioWithOneThread("interval-volume", "clip2-tetrahedra")),
    BenchClaim::AtLeast("a second thread gives at least 1.7", 1.7, rows, secondThread),
    BenchClaim::AtMost("2 threads, a dragged bound, where less than a tenth of the cells changes: "
                       "at most 0.1 s an update",
      0.1, rows, dragged),
    BenchClaim::AtMost("the first extraction in a process: at most 0.03 s more than the second",
      0.03, rows, ofFirstUse),
    BenchClaim::AtMost("peak memory at most the input and 1.5 times the output", 1.5, rows,
      CountOf("memory", "peak_share")) };
}

std::vector<BenchPlot> SuiteInterval::MakePlots(const std::vector<BenchRow>& rows) const
{
  std::vector<BenchPlot> plots = MakeRatioPlots("interval", "interval-volume", rows);
  for (BenchPlot& plot : MakeReExtractionPlots("interval", rows))
  {
    plots.push_back(std::move(plot));
  }
  for (BenchPlot& plot : interval::MakeErrorPlots(rows))
  {
    plots.push_back(std::move(plot));
  }
  return plots;
}
}

std::unique_ptr<BenchSuite> MakeIntervalSuite()
{
  return std::make_unique<SuiteInterval>();
}

// SPDX-License-Identifier: BSD-3-Clause
// Measures extraction and implicit flow in several processes with one thread each. Start it with
// mpiexec on 1, 2, 4, ... processes, with a separate JSON file for each run; --from combines these
// files. See RankRows.h.
#include "Benchmarks/Ranks/RankCases.h"
#include "Benchmarks/Ranks/RankMeasures.h"
#include "Benchmarks/Ranks/RankRows.h"

#include "vtkImplicitFlowField.h"
#include "vtkIntervalVolume.h"

#include "vtkMPIController.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"

#include <CLI/CLI.hpp>

#include <chrono>
#include <cmath>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace
{
/// All processes take part in the measurements, but only process 0 adds the rows.
void Measure(vtkMultiProcessController* controller, const BenchOptions& options, BenchRows& rows)
{
  const int ranks = controller->GetNumberOfProcesses();
  const bool isFirst = controller->GetLocalProcessId() == 0;
  const int repeats = options.GetRepeats();
  const auto add = [&](const auto& makeRow)
  {
    if (isFirst)
    {
      rows.Add(makeRow());
    }
  };
  // Measure memory first, before other measurements free memory that could be reused.
  const std::vector<double> flowKib =
    ranks::MeasureMemory(controller, ranks::MakeFlow(options.Pick(201, 61, 17), 1, 8));
  add([&]() { return ranks::MakeMemoryRow(rows, "flow", ranks, flowKib); });
  const std::vector<double> volumeKib =
    ranks::MeasureMemory(controller, ranks::MakeVolume(options.Pick(160, 64, 16), 1));
  add([&]() { return ranks::MakeMemoryRow(rows, "extraction", ranks, volumeKib); });
  const auto volume = ranks::MakeVolume(options.Pick(96, 48, 16), ranks);
  const ranks::Times volumeTimes = ranks::MeasureTimes(controller, volume, repeats,
    [&volume]() { return volume->GetReport()->GetNumber("CellsWithOutput"); });
  add([&]() { return ranks::MakeWeakRow(rows, "extraction", volumeTimes); });
  const auto flow = ranks::MakeFlow(options.Pick(64, 24, 12), ranks, options.Pick(32, 16, 8));
  const ranks::Times flowTimes = ranks::MeasureTimes(controller, flow, repeats,
    [&]()
    {
      vtkInterlumeReport* report = flow->GetReport();
      const int rank = controller->GetLocalProcessId();
      return rank < report->GetSize("StepsPerProcess") ? report->GetNumber("StepsPerProcess", rank)
                                                       : report->GetNumber("Steps");
    });
  add([&]() { return ranks::MakeWeakRow(rows, "flow", flowTimes); });
}

void JoinFiles(const std::vector<std::string>& from, const std::string& json)
{
  std::vector<BenchResults> runs;
  for (const std::string& path : from)
  {
    runs.push_back(BenchResults::Read(path));
  }
  ranks::Join(runs).Write(json);
}
}

int main(int argc, char* argv[])
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  vtkMultiProcessController::SetGlobalController(controller);
  vtkSMPTools::Initialize(1);
  bool isQuick = false;
  bool isTiny = false;
  std::string json;
  std::vector<std::string> from;
  CLI::App app("Measures extraction and implicit flow in the processes that mpiexec starts");
  app.add_flag("--quick", isQuick, "Smaller cases and fewer repetitions");
  app.add_flag("--tiny", isTiny, "The smallest cases, for tests");
  auto* file = app.add_option("--json", json, "Write the rows to this file");
  app
    .add_option("--from", from,
      "Combine the files of runs with different numbers of processes instead of measuring")
    ->check(CLI::ExistingFile)
    ->needs(file);
  int status = 0;
  try
  {
    app.parse(argc, argv);
    if (!from.empty())
    {
      JoinFiles(from, json);
    }
    else
    {
      BenchOptions options;
      options.Size = isTiny ? BenchOptions::TINY
        : isQuick           ? BenchOptions::QUICK
                            : BenchOptions::FULL;
      BenchResults results = BenchResults::MakeForThisMachine(options);
      results.Conditions["command"] = "mpiexec -n " +
        std::to_string(controller->GetNumberOfProcesses()) + " interlume-bench-ranks" +
        (isTiny       ? " --tiny"
            : isQuick ? " --quick"
                      : "");
      const auto start = std::chrono::steady_clock::now();
      BenchRows rows(ranks::Suite);
      Measure(controller, options, rows);
      results.Rows = rows.Get();
      results.Suites[ranks::Suite]["took"] =
        std::round(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
      if (!json.empty() && controller->GetLocalProcessId() == 0)
      {
        results.Write(json);
      }
    }
  }
  catch (const CLI::ParseError& error)
  {
    status = controller->GetLocalProcessId() == 0 ? app.exit(error) : error.get_exit_code();
  }
  catch (const std::exception& error)
  {
    std::cerr << "interlume-bench-ranks: " << error.what() << "\n";
    status = 1;
  }
  vtkMultiProcessController::SetGlobalController(nullptr);
  controller->Finalize();
  return status;
}

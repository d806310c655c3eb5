// SPDX-License-Identifier: BSD-3-Clause
// Measures Interlume against filters and mappers of VTK; see --help.
#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Report/PlotSvg.h"
#include "Benchmarks/Report/ReportPage.h"
#include "Benchmarks/Results/BenchMachine.h"
#include "Benchmarks/Results/BenchResults.h"
#include "Benchmarks/Suites/BenchSuite.h"
#include "Support/Pages/StabilityCase.h"

#include "vtkSMPTools.h"

#include <CLI/CLI.hpp>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>

namespace
{
using Suites = std::vector<BenchSuite>;

/// Command-line arguments: the common options of the suites and the options of this program.
struct Arguments
{
  BenchOptions Options;
  bool List = false;
  bool Quick = false;
  bool Tiny = false;
  bool Spans = false;
  std::vector<std::string> Suites;
  std::string Task;
  std::string Json;
  std::string Plots;
  std::string Data;
  bool Report = false;
  std::string Out;
  std::string From;
  std::string Costs;
  std::string Stability = INTERLUME_STABILITY_DIR;
};

void Define(CLI::App& app, Arguments& arguments, const std::vector<std::string>& names)
{
  app.add_flag("--list", arguments.List, "Print all suites with a short description");
  app.add_option("SUITE", arguments.Suites, "Suites to run")->check(CLI::IsMember(names));
  app.add_option("--json", arguments.Json, "Write the rows to this file");
  app.add_option("--plots", arguments.Plots, "Draw the plots into this directory");
  app.add_option("--from", arguments.From, "Read the rows of an earlier run instead of measuring")
    ->check(CLI::ExistingFile);
  app.add_flag("--spans", arguments.Spans,
    "With --json: write when each run began and ended, in seconds of the monotonic clock");
  app.add_flag("--quick", arguments.Quick, "Smaller cases: less than 45 s per suite on two cores");
  app
    .add_option(
      "--threads", arguments.Options.Threads, "Number of threads of rows that use all threads")
    ->check(CLI::Range(1, 4096))
    ->capture_default_str();
  app.add_option("--seed", arguments.Options.Seed, "Seed of the random values")
    ->capture_default_str();
  app
    .add_option(
      "--data", arguments.Data, "Directory of the data files; default: the project's Data")
    ->check(CLI::ExistingDirectory);
  // Hidden options for the tests of this program and for the child processes that it starts.
  app.add_flag("--tiny", arguments.Tiny)->group("");
  app.add_option("--task", arguments.Task)->group("");

  CLI::App* report =
    app.add_subcommand("report", "Run all suites and write the results as one page");
  report->fallthrough();
  report->add_option("--out", arguments.Out, "Directory of the page")->required();
  report->add_option("--stability", arguments.Stability, "Directory of the stability cases")
    ->capture_default_str();
  report
    ->add_option(
      "--costs", arguments.Costs, "File written by interlume-bench-costs, added to the page")
    ->check(CLI::ExistingFile);
  report->callback([&arguments]() { arguments.Report = true; });
}

/// Returns the results of an earlier run, or empty results for this machine.
BenchResults Start(const Arguments& arguments)
{
  return arguments.From.empty() ? BenchResults::MakeForThisMachine(arguments.Options)
                                : BenchResults::Read(arguments.From);
}

/// Runs the suite, unless its rows were read from an earlier run, and checks its claims.
void Run(const BenchSuite& suite, const Arguments& arguments, BenchResults& results)
{
  if (arguments.From.empty())
  {
    BenchRows rows(suite.Name);
    const BenchSeconds took = TimeOnce(
      [&]()
      {
        suite.Run(arguments.Options, rows);
        return vtkSmartPointer<vtkObjectBase>();
      });
    results.Rows.insert(results.Rows.end(), rows.Get().begin(), rows.Get().end());
    results.Suites[suite.Name]["took"] = std::round(took);
  }
  const std::vector<BenchRow> rows = results.RowsOf(suite.Name);
  if (arguments.From.empty() || !rows.empty())
  {
    results.SetClaims(suite.Name, suite.CheckClaims(rows));
  }
}

const BenchSuite& Find(const Suites& suites, const std::string& name)
{
  return *std::find_if(
    suites.begin(), suites.end(), [&name](const BenchSuite& suite) { return suite.Name == name; });
}

/// Returns the caption that all plots share.
std::string CaptionOf(const BenchResults& results)
{
  return MachineInOneLine(results.Machine, results.Vtk) + "\n" +
    ConditionsInOneLine(results.Conditions);
}

void WriteReport(const Suites& suites, const Arguments& arguments)
{
  // Gather the stability cases first: this may fail, and the suites take a long time.
  const std::vector<StabilityCase> cases = StabilityCatalogue::Gather(arguments.Stability);
  BenchResults results = Start(arguments);
  for (const BenchSuite& suite : suites)
  {
    Run(suite, arguments, results);
  }
  const std::filesystem::path folder = arguments.Out;
  std::filesystem::create_directories(folder);
  results.Write((folder / "rows.json").string());
  ReportPage page(results);
  for (const BenchSuite& suite : suites)
  {
    page.AddSuite(suite,
      WritePlots(suite.MakePlots(results.RowsOf(suite.Name)), arguments.Out, CaptionOf(results)));
  }
  if (!arguments.Costs.empty())
  {
    page.AddCosts(BenchResults::Read(arguments.Costs));
  }
  page.AddStabilityCatalog(cases);
  const std::string path = (folder / "index.html").string();
  page.Write(path);
  std::cout << path << std::endl;
}

void RunSuites(const Suites& suites, const Arguments& arguments)
{
  BenchResults results = Start(arguments);
  for (const std::string& name : arguments.Suites)
  {
    const BenchSuite& suite = Find(suites, name);
    if (!arguments.From.empty() && results.RowsOf(name).empty())
    {
      throw std::runtime_error(arguments.From + " has no rows of " + name);
    }
    Run(suite, arguments, results);
    if (!arguments.Plots.empty())
    {
      WritePlots(suite.MakePlots(results.RowsOf(name)), arguments.Plots, CaptionOf(results));
    }
  }
  if (!arguments.Json.empty())
  {
    results.Write(arguments.Json, arguments.Spans);
  }
}

int Execute(const Suites& suites, const CLI::App& app, const Arguments& arguments)
{
  if (arguments.List)
  {
    for (const BenchSuite& suite : suites)
    {
      std::cout << suite.Name << "\t" << suite.Title << "\n";
    }
  }
  else if (!arguments.Task.empty() && arguments.Suites.size() == 1)
  {
    const BenchSuite& suite = Find(suites, arguments.Suites[0]);
    std::cout << suite.RunTask(arguments.Task, arguments.Options) << std::endl;
  }
  else if (arguments.Report)
  {
    WriteReport(suites, arguments);
  }
  else if (!arguments.Suites.empty())
  {
    RunSuites(suites, arguments);
  }
  else
  {
    std::cerr << app.help();
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
}

int main(int argc, char* argv[])
{
  const Suites suites = MakeAllSuites();
  std::vector<std::string> names;
  for (const BenchSuite& suite : suites)
  {
    names.push_back(suite.Name);
  }
  Arguments arguments;
  arguments.Options.Threads = vtkSMPTools::GetEstimatedNumberOfThreads();
  CLI::App app("Measures Interlume against filters and mappers of VTK", "interlume-bench");
  Define(app, arguments, names);
  CLI11_PARSE(app, argc, argv);

  arguments.Options.Size = arguments.Tiny ? BenchOptions::TINY
    : arguments.Quick                     ? BenchOptions::QUICK
                                          : BenchOptions::FULL;
  std::string reason;
  vtksys::SystemTools::FindProgramPath(argv[0], arguments.Options.Program, reason);
  if (!arguments.Data.empty())
  {
    vtksys::SystemTools::PutEnv("INTERLUME_DATA=" + arguments.Data);
  }
  try
  {
    return Execute(suites, app, arguments);
  }
  catch (const std::exception& error)
  {
    std::cerr << "interlume-bench: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}

// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchSuite_h
#define BenchSuite_h

#include "Benchmarks/Results/BenchClaim.h"
#include "Benchmarks/Results/BenchPlot.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

/**
 * One of the things that a suite measures. Any function may be missing.
 */
struct BenchPart
{
  using Task = nlohmann::ordered_json (*)(const std::string& argument, const BenchOptions& options);

  std::function<void(const BenchOptions& options, BenchRows& rows)> AddRows = {};
  /// The plots of \a rows, which are of this suite.
  std::function<std::vector<BenchPlot>(const std::vector<BenchRow>& rows)> MakePlots = {};
  /// The targets, and whether \a rows, which are of this suite, meet them.
  std::function<std::vector<BenchClaim>(const std::vector<BenchRow>& rows)> CheckClaims = {};
  /// What RunChild() can execute, by name.
  std::map<std::string, Task> Tasks = {};
};

/**
 * A group of measurements that is run, written and plotted together. A new suite is a function that
 * returns one, listed in MakeAllSuites().
 */
struct BenchSuite
{
  /// The name on the command line and in the field `suite`.
  std::string Name;
  /// One line for --list.
  std::string Title;
  /// Describes what is measured and how, in plain text, a paragraph a string, for the report.
  std::vector<std::string> Description;
  std::vector<BenchPart> Parts;

  void Run(const BenchOptions& options, BenchRows& rows) const;
  std::vector<BenchPlot> MakePlots(const std::vector<BenchRow>& rows) const;
  std::vector<BenchClaim> CheckClaims(const std::vector<BenchRow>& rows) const;

  /// Executes a task, its name and its argument with a space between, in the process that
  /// RunChild() started. Throws std::runtime_error if there is no such task.
  nlohmann::ordered_json RunTask(const std::string& task, const BenchOptions& options) const;
};

/**
 * Executes a task of a suite in a fresh process with the same options, and returns its result.
 * Throws std::runtime_error, with the command, if the process fails.
 */
nlohmann::ordered_json RunChild(
  const std::string& suite, const std::string& task, const BenchOptions& options);

/**
 * Every suite, in the order of the report.
 */
std::vector<BenchSuite> MakeAllSuites();

#endif

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
 * A part of a suite. Each function may be empty.
 */
struct BenchPart
{
  using Task = nlohmann::ordered_json (*)(const std::string& argument, const BenchOptions& options);

  std::function<void(const BenchOptions& options, BenchRows& rows)> AddRows = {};
  /// Returns the plots of \a rows, which are the rows of all parts of the suite.
  std::function<std::vector<BenchPlot>(const std::vector<BenchRow>& rows)> MakePlots = {};
  /// Returns the claims about \a rows, which are the rows of all parts of the suite.
  std::function<std::vector<BenchClaim>(const std::vector<BenchRow>& rows)> CheckClaims = {};
  /// Functions that RunChild() can execute, by name.
  std::map<std::string, Task> Tasks = {};
};

/**
 * A group of measurements that are run, written and plotted together. To add a suite, write a
 * function that returns it and call that function in MakeAllSuites().
 */
struct BenchSuite
{
  /// Name on the command line and in the field `suite` of rows.
  std::string Name;
  /// One-line description for --list.
  std::string Title;
  /// Description of the measurements and methods for the report, as plain text with one paragraph
  /// per string.
  std::vector<std::string> Description;
  std::vector<BenchPart> Parts;

  void Run(const BenchOptions& options, BenchRows& rows) const;
  std::vector<BenchPlot> MakePlots(const std::vector<BenchRow>& rows) const;
  std::vector<BenchClaim> CheckClaims(const std::vector<BenchRow>& rows) const;

  /// Executes a task in the process started by RunChild(). \a task is the name and the argument,
  /// separated by a space. Throws std::runtime_error if the task does not exist.
  nlohmann::ordered_json RunTask(const std::string& task, const BenchOptions& options) const;
};

/**
 * Executes a task of a suite in a new process with the same options, and returns its result. Throws
 * std::runtime_error, with the command in the message, if the process fails.
 */
nlohmann::ordered_json RunChild(
  const std::string& suite, const std::string& task, const BenchOptions& options);

/**
 * Returns all suites in the order of the report.
 */
std::vector<BenchSuite> MakeAllSuites();

#endif

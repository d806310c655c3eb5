// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchSuite_h
#define BenchSuite_h

#include "Benchmarks/Results/BenchClaim.h"
#include "Benchmarks/Results/BenchPlot.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include <memory>
#include <string>
#include <vector>

/**
 * @class   BenchSuite
 * @brief   a group of measurements that is run, written and plotted together
 *
 * A new suite is a file `Suite<Name>.cxx` that derives from this class and defines one function
 * Make<Name>Suite(), declared and listed in BenchSuites.
 */
class BenchSuite
{
public:
  virtual ~BenchSuite() = default;

  /**
   * The name on the command line and in the field `suite`.
   */
  virtual std::string GetName() const = 0;

  /**
   * One line for --list.
   */
  virtual std::string GetTitle() const = 0;

  /**
   * What is measured and how, in plain text, a paragraph a string, for the report.
   */
  virtual std::vector<std::string> GetDescription() const = 0;

  /**
   * Measures and adds the rows.
   */
  virtual void Run(const BenchOptions& options, BenchRows& rows) const = 0;

  /**
   * The plots of \a rows, which are of this suite. By default none.
   */
  virtual std::vector<BenchPlot> MakePlots(const std::vector<BenchRow>& rows) const;

  /**
   * What is wanted of \a rows, which are of this suite, and whether it is so. By default nothing.
   */
  virtual std::vector<BenchClaim> CheckClaims(const std::vector<BenchRow>& rows) const;

  /**
   * Called in the fresh process that RunChild() started: does the work \a task and returns what the
   * caller of RunChild() gets. By default throws std::runtime_error.
   */
  virtual nlohmann::ordered_json RunTask(
    const std::string& task, const BenchOptions& options) const;

protected:
  /**
   * Does \a task by RunTask() in a fresh process with the same options. Throws std::runtime_error,
   * with the command, where the process fails.
   */
  nlohmann::ordered_json RunChild(const std::string& task, const BenchOptions& options) const;
};

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchResults_h
#define BenchResults_h

#include "Benchmarks/Results/BenchClaim.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include <string>
#include <vector>

/**
 * The results that a benchmark program writes: machine, VTK version, conditions, information on
 * each suite, and rows.
 */
struct BenchResults
{
  nlohmann::ordered_json Machine;
  std::string Vtk;
  /// See DescribeConditions().
  nlohmann::ordered_json Conditions;
  /// For each suite name: `took`, the wall time of the suite in seconds, and `claims`, the claims
  /// about its rows.
  nlohmann::ordered_json Suites = nlohmann::ordered_json::object();
  std::vector<BenchRow> Rows;

  /// Returns results without rows, for this machine, this VTK version and the conditions of
  /// \a options.
  static BenchResults MakeForThisMachine(const BenchOptions& options);

  /// Reads results from a file. Throws std::runtime_error with the path if the file cannot be read
  /// or parsed.
  static BenchResults Read(const std::string& path);
  /// Writes the results, including the start and end of each run if \a hasSpans is set. Throws
  /// std::runtime_error with the path if the file cannot be written.
  void Write(const std::string& path, bool hasSpans = false) const;

  /// Sets the claims about the rows of \a suite.
  void SetClaims(const std::string& suite, const std::vector<BenchClaim>& claims);

  std::vector<BenchRow> RowsOf(const std::string& suite) const;
};

#endif

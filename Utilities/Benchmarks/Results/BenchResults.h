// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchResults_h
#define BenchResults_h

#include "Benchmarks/Results/BenchClaim.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include <string>
#include <vector>

/**
 * What the program writes: the machine, the VTK version, the conditions, what is said of each
 * suite, and the rows.
 */
struct BenchResults
{
  nlohmann::ordered_json Machine;
  std::string Vtk;
  /// See DescribeConditions().
  nlohmann::ordered_json Conditions;
  /// By name: `took`, the wall seconds of the suite, and `claims`, what is wanted of its rows.
  nlohmann::ordered_json Suites = nlohmann::ordered_json::object();
  std::vector<BenchRow> Rows;

  /// This machine, this VTK and these conditions, no rows.
  static BenchResults Here(const BenchOptions& options);

  /// Throws std::runtime_error, with the path, where the file cannot be read or is not such a file.
  static BenchResults Read(const std::string& path);
  /// With \a hasSpans also when each run began and ended. Throws std::runtime_error, with the path,
  /// where the file cannot be written.
  void Write(const std::string& path, bool hasSpans = false) const;

  /// Sets what is wanted of the rows of \a suite.
  void SetClaims(const std::string& suite, const std::vector<BenchClaim>& claims);

  /// The rows of one suite.
  std::vector<BenchRow> RowsOf(const std::string& suite) const;
};

#endif

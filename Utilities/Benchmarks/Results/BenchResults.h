// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchResults_h
#define BenchResults_h

#include "Benchmarks/Results/BenchRow.h"

#include <string>
#include <vector>

/**
 * What the program writes: the machine, the VTK version and the rows.
 */
struct BenchResults
{
  nlohmann::ordered_json Machine;
  std::string Vtk;
  std::vector<BenchRow> Rows;

  /// This machine and this VTK, no rows.
  static BenchResults Here();

  /// Throws std::runtime_error, with the path, where the file cannot be read or is not such a file.
  static BenchResults Read(const std::string& path);
  /// Throws std::runtime_error, with the path, where the file cannot be written.
  void Write(const std::string& path) const;

  /// The rows of one suite.
  std::vector<BenchRow> RowsOf(const std::string& suite) const;
};

#endif

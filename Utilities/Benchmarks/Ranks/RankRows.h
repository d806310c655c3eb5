// SPDX-License-Identifier: BSD-3-Clause
#ifndef RankRows_h
#define RankRows_h

#include "Benchmarks/Ranks/RankMeasures.h"
#include "Benchmarks/Results/BenchResults.h"

#include <string>
#include <vector>

/**
 * Rows of measurements with several processes. The parameter of all rows is the number of
 * processes.
 */
namespace ranks
{
constexpr const char* Suite = "ranks";

/// Returns the row for weak scaling, where the work per process is constant. `seconds` is the wall
/// time of the slowest process. Counts: `processor_seconds` and `work`, the means over all
/// processes, and `most_processor_seconds`, the maximum of the processor times.
BenchRow MakeWeakRow(const BenchRows& rows, const std::string& theCase, const Times& times);

/// Returns the row for memory, where the total work is constant. The count `kib` is the maximum
/// over all processes.
BenchRow MakeMemoryRow(
  const BenchRows& rows, const std::string& theCase, int ranks, const std::vector<double>& kib);

/**
 * Combines runs with different numbers of processes. Adds two counts to the rows: `efficiency`, the
 * processor time in the run with one process divided by the mean processor time of all processes,
 * and `share`, the memory divided by the memory in the run with one process.
 */
BenchResults Join(const std::vector<BenchResults>& runs);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef RankRows_h
#define RankRows_h

#include "Benchmarks/Ranks/RankMeasures.h"
#include "Benchmarks/Results/BenchResults.h"

#include <string>
#include <vector>

/**
 * Rows of measurements with several processes. The parameter is the number of processes.
 */
namespace ranks
{
constexpr const char* Suite = "ranks";

/// Returns the row for weak scaling, in which the work per process is constant. `seconds` is the
/// time of the slowest process. Counts: `processor_seconds` and `work`, means over the processes,
/// and `most_processor_seconds`.
BenchRow MakeWeakRow(const BenchRows& rows, const std::string& theCase, const Times& times);

/// Returns the memory row for a constant total amount of work. The count `kib` is the maximum over
/// all processes.
BenchRow MakeMemoryRow(
  const BenchRows& rows, const std::string& theCase, int ranks, const std::vector<double>& kib);

/**
 * Combines the rows of runs with several numbers of processes. Adds `efficiency`, the processor
 * time of a single process divided by the mean processor time of the processes, and `share`, the
 * memory divided by the memory of a single process.
 */
BenchResults Join(const std::vector<BenchResults>& runs);
}

#endif

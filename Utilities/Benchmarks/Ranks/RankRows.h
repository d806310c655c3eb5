// SPDX-License-Identifier: BSD-3-Clause
#ifndef RankRows_h
#define RankRows_h

#include "Benchmarks/Ranks/RankMeasures.h"
#include "Benchmarks/Results/BenchResults.h"

#include <string>
#include <vector>

/**
 * The rows of what several processes take. Their parameter is how many there are.
 */
namespace ranks
{
constexpr const char* Suite = "ranks";

/// Every process has as much to do, however many there are: `seconds` of the slowest; counts
/// `processor_seconds` and `work`, means of the processes, and `most_processor_seconds`.
BenchRow MakeWeakRow(const BenchRows& rows, const std::string& theCase, const Times& times);

/// The same work for any number: counts `kib`, of the process that takes most.
BenchRow MakeMemoryRow(
  const BenchRows& rows, const std::string& theCase, int ranks, const std::vector<double>& kib);

/**
 * Combines the rows of runs with several numbers of processes: adds `efficiency`, the mean
 * processor time of one process over that of each, and `share`, the memory over that of one
 * process.
 */
BenchResults Join(const std::vector<BenchResults>& runs);
}

#endif

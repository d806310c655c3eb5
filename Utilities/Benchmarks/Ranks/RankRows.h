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

/// One step of what the suite growth computes for a cluster: counts `cells` of a rank,
/// `processor_seconds` of the mean one, and `kib` of the one that takes most, its input in it.
BenchRow MakePointRow(
  const BenchRows& rows, double cells, const Times& times, const std::vector<double>& kib);

/**
 * Puts together what runs of several numbers of processes have written: adds `efficiency`, the mean
 * processor time of one process over that of each, and `share`, the memory over that of one; and,
 * where \a growth has the rows of the suite growth, `computed_seconds` and `computed_kib` of a
 * point.
 */
BenchResults Join(const std::vector<BenchResults>& runs, const std::vector<BenchRow>& growth);
}

#endif

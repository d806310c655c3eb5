// SPDX-License-Identifier: BSD-3-Clause
#ifndef ClusterNeeds_h
#define ClusterNeeds_h

#include "Benchmarks/Results/BenchRow.h"

#include <optional>
#include <string>
#include <vector>

namespace growth
{
/// What a rank of one thread needs.
struct RankNeed
{
  double Seconds = 0.0;
  double InputKib = 0.0;
  /// Over the input.
  double Kib = 0.0;
};

/**
 * What the interval volume of one step of \a cells cells a rank needs, computed from the largest
 * size and the fitted exponents of the quantity `cells` among \a rows; nothing where these are
 * missing.
 */
std::optional<RankNeed> ComputeVolumeOfStep(double cells, const std::vector<BenchRow>& rows);

/**
 * How ClusterNeeds are computed, for the report.
 */
std::vector<std::string> DescribeClusterNeeds();

/**
 * Adds what 1024^3 cells of one float each at 100 time steps would need on ranks of one thread
 * each, computed from the largest sizes and the fitted exponents of the quantities `cells`, `cells
 * in time` and `time steps` among \a rows; nothing where these are missing. Methods `computed:
 * interval volume of each step`, `computed: in time, slab by slab` and `computed: in time, all at
 * once`; the parameter and the count `ranks` are how many; counts `computed_seconds` and
 * `kib_a_rank`, of which `input_kib_a_rank` are the time steps held.
 */
void AddClusterRows(BenchRows& rows);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef CostRows_h
#define CostRows_h

#include "Benchmarks/Results/BenchClaim.h"
#include "Benchmarks/Results/BenchRow.h"

#include <string>
#include <vector>

/**
 * Rows of interlume-bench-costs, of the suite `scene-costs`.
 *
 * The case is a scene, the method a class, the parameter a feature, by the name of its setting,
 * that an object of the class does not use there. Seconds are those of an object that never had it,
 * medians. The counts `passes`, `buffers`, `bytes`, `words` and `arrays` are what is left of it
 * once it was on, `own` is its share of reports while it is off, `ms` the milliseconds that are
 * left, `noise_ms` the differences without reason, `within_noise` 1 if `ms` is no more; with `on_`
 * what it adds while it is on.
 *
 * Summaries have the case AllScenes: the number of `scenes` that do not use the feature, the
 * largest of what is left, medians of times and of what it adds, and how many scenes are
 * `within_noise`.
 */
namespace costs
{
extern const char* const Suite;
extern const char* const AllScenes;

/// Returns the summaries of rows that are none themselves.
std::vector<BenchRow> Summarize(const std::vector<BenchRow>& rows);

/// That nothing is left of any feature in any scene, and no time but for noise; cases are the rows
/// where it is not so, and the number of the others.
std::vector<BenchClaim> CheckClaims(const std::vector<BenchRow>& rows);
}

#endif

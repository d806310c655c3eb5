// SPDX-License-Identifier: BSD-3-Clause
#ifndef CostRows_h
#define CostRows_h

#include "Benchmarks/Results/BenchClaim.h"
#include "Benchmarks/Results/BenchRow.h"

#include <string>
#include <vector>

/**
 * What interlume-bench-costs writes, rows of the suite `scene-costs`.
 *
 * Of a scene, which is the case:
 * - method a class, parameter a feature, as its setting is called, that an object of the class does
 *   not use there. Seconds are those of an object that never had it, medians. The counts `passes`,
 *   `buffers`, `bytes`, `words` and `arrays` are what is left of it once it was on, `own` is what
 *   reports say of it while it is off, `ms` the milliseconds that are left, `noise_ms` what these
 *   differ by without reason, `within_noise` 1 where they are no more; with `on_` what it adds
 * while it is on.
 * - method a class that the scene executes, no parameter, with `executions`, `arrays` and `bytes`.
 *
 * Summaries:
 * - case AllScenes, method a class, parameter a feature: the numbers of `scenes` that do not use
 * it, the largest of what is left, medians of times and of what it adds, and how many scenes are
 *   `within_noise`.
 * - case AllScenes, method a class: how many `scenes` execute it, how many `others` do not, and so
 *   have no execution, array or byte of it.
 * - case a scene, method AllFeatures: likewise over the `features` that it does not use.
 */
namespace costs
{
extern const char* const Suite;
extern const char* const AllScenes;
extern const char* const AllFeatures;

/// The numbers of rows that are summaries are made of the other ones.
std::vector<BenchRow> Summarise(const std::vector<BenchRow>& rows);

/// That nothing is left of any feature in any scene, and no time but for noise; cases are the rows
/// where it is not so, and the number of the others.
std::vector<BenchClaim> CheckClaims(const std::vector<BenchRow>& rows);
}

#endif

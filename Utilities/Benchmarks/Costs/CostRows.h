// SPDX-License-Identifier: BSD-3-Clause
#ifndef CostRows_h
#define CostRows_h

#include "Benchmarks/Results/BenchClaim.h"
#include "Benchmarks/Results/BenchRow.h"

#include <string>
#include <vector>

/**
 * Rows of the suite `scene-costs`, which interlume-bench-costs measures.
 *
 * In each row, the case is a scene, the method is a class, and the parameter is a feature that an
 * object of the class does not use in the scene. A feature is named after its setting. Seconds are
 * the median time of an object that never used the feature.
 *
 * The counts `passes`, `buffers`, `bytes`, `words` and `arrays` are the resources that remain after
 * the feature was switched on and off again. `own` is the larger of the values of Feature::Own
 * before the feature is switched on and after it is switched off. `ms` is the extra time in
 * milliseconds that remains, `noise_ms` is the noise of the times, and `within_noise` is 1 if `ms`
 * does not exceed the noise. Counts with the prefix `on_` are the cost of the feature while it is
 * on.
 *
 * Summaries have the case AllScenes. `scenes` is the number of scenes that do not use the feature,
 * and `within_noise` is the number of scenes in which `ms` does not exceed the noise. Other counts
 * are the largest remaining resources, median times, and medians of the `on_` counts.
 */
namespace costs
{
extern const char* const Suite;
extern const char* const AllScenes;

/// Returns a summary of each feature over all scenes. \a rows must not contain summaries.
std::vector<BenchRow> Summarize(const std::vector<BenchRow>& rows);

/// Returns two claims: no feature leaves resources in any scene after it is switched off, and the
/// extra times that remain are within the noise. Their cases are the rows that miss the target, and
/// the number of rows that meet it.
std::vector<BenchClaim> CheckClaims(const std::vector<BenchRow>& rows);
}

#endif

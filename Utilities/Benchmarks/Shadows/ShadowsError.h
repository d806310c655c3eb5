// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShadowsError_h
#define ShadowsError_h

#include "Benchmarks/Results/BenchClaim.h"
#include "Benchmarks/Results/BenchPlot.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include <vector>

/**
 * The part of the suite `shadows` about error against run time.
 */
namespace shadows
{
/**
 * Pictures of one light against a ray marcher in double precision with shadow rays, as
 * `<case>, scattering` (see MakeScattering) and `<case>, shaded` (without gpu-shadows, whose
 * shading is another). Methods:
 * - `spacing`: the parameter is the distance of slices over the default one;
 * - `buffer`: the parameter is the size of the light's buffer;
 * - `gpu-shadows`: the parameter is the distance of samples in voxels.
 *
 * One row for each norm: `channel difference, mean`, with the marcher's picture, and
 * `channel difference from its own limit, mean`, with the same mapper's picture with slices at
 * an eighth of the default distance or samples every quarter of a voxel.
 *
 * Rows of method `equal-error`: the time of the default, and as peer_seconds that of gpu-shadows
 * where its line in the log-log plot has the same error; with at_least 1 in the counts where it
 * never has, and the time is that of its smallest error.
 */
void AddErrorRows(const BenchOptions& options, BenchRows& rows);

std::vector<BenchClaim> CheckErrorClaims(const std::vector<BenchRow>& rows);
/// A plot for each case, of the first norm.
std::vector<BenchPlot> MakeErrorPlots(const std::vector<BenchRow>& rows);
}

#endif

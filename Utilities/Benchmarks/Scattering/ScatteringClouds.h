// SPDX-License-Identifier: BSD-3-Clause
#ifndef ScatteringClouds_h
#define ScatteringClouds_h

#include "Benchmarks/Results/BenchPlot.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include <vector>

namespace scattering
{
/**
 * Pictures of a cloud against those of reference::TraceScene. Methods `single`, `forward` and
 * `full`; the parameter is `default`, or what is not: `grid 16`, `buffer 128`, `spacing 2`, in
 * default spacings. Counts of the default of full: over_shadowed, its time over that of the same
 * picture without scattered light. `monte-carlo`: the parameter is the number of paths of a pixel,
 * the error that of its noise. `equal-error`: the default of full, and as peer the time that
 * `monte-carlo` takes for the same error.
 */
void AddCloudRows(const BenchOptions& options, BenchRows& rows);

/**
 * Pictures of the cloud where only the view turns, so that scattered light is kept. Methods
 * `single`, `forward`, `full`; the parameter is the number of columns and rows of the picture, the
 * peer the same picture without scattered light. Counts: view_over_shadowed, the times' ratio;
 * solves, how often scattered light was found, once.
 */
void AddViewRows(const BenchOptions& options, BenchRows& rows);

/// Error against run time of a cloud.
std::vector<BenchPlot> MakeCloudPlots(const std::vector<BenchRow>& rows);
}

#endif

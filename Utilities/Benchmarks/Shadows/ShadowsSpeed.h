// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShadowsSpeed_h
#define ShadowsSpeed_h

#include "Benchmarks/Results/BenchClaim.h"
#include "Benchmarks/Results/BenchPlot.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include <vector>

/**
 * The part of the suite `shadows` about run time and memory.
 */
namespace shadows
{
/**
 * One frame of each case. The parameter is the number of lights. Methods:
 * - `shadows` against the peer `shadows-off`, the same lights without shadows; over_off is the time
 *   over that of the peer, over_one_light that over the time with one light;
 * - `shadows, both sides`: of two lights one is behind the volume;
 * - `shadows` of one light against `gpu-shadows`, and `shadows-off` against `gpu`;
 * - `unlit`, a light that neither shades nor casts shadows, against `no-lights`, the same volume in
 *   a scene without lights.
 */
void AddSpeedRows(const BenchOptions& options, BenchRows& rows);

std::vector<BenchClaim> CheckSpeedClaims(const std::vector<BenchRow>& rows);
/// Bars of the time with lights over that without shadows.
std::vector<BenchPlot> MakeSpeedPlots(const std::vector<BenchRow>& rows);
}

#endif

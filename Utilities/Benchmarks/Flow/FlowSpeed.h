// SPDX-License-Identifier: BSD-3-Clause
#ifndef FlowSpeed_h
#define FlowSpeed_h

#include "Benchmarks/Results/BenchClaim.h"
#include "Benchmarks/Results/BenchPlot.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include <vector>

/**
 * What the suite `flow-speed` measures: run time against vtkStreamTracer.
 */
namespace flow
{
/**
 * Streamlines of ABC flow to a box, by one thread. Methods:
 * - `advection`, and the peer's `RK4` and `RK45`: error against run time, the parameter being
 *   MaximumError over the largest speed, the step in cells, and MaximumError;
 * - `equal-error`: the default of the advection against the peers `streamtracer-RK4` and
 *   `streamtracer-RK45` at the first of their settings, halved or divided by ten each time, of an
 *   error no more than twice that of the advection;
 * - `threads-2`: two threads against one.
 */
void AddSpeedRows(const BenchOptions& options, BenchRows& rows);

std::vector<BenchClaim> CheckSpeedClaims(const std::vector<BenchRow>& rows);
/// Error against run time, a plot for each case.
std::vector<BenchPlot> MakeSpeedPlots(const std::vector<BenchRow>& rows);
}

#endif

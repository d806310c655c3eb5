// SPDX-License-Identifier: BSD-3-Clause
#ifndef Interval4dThroughput_h
#define Interval4dThroughput_h

#include "Benchmarks/Results/BenchPlot.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include <vector>

/**
 * The part of the suite `interval4d` about run time against the size of the output.
 */
namespace interval4d
{
/**
 * Method `throughput`, by one thread, warm: f >= c of the field VORTEX on grids of several sizes, c
 * chosen so that a share of the grid's points, which is the parameter, is inside at time 0.
 */
void AddThroughputRows(const BenchOptions& options, BenchRows& rows);

/// 4-simplices a second against 4-simplices, a line for each grid.
std::vector<BenchPlot> MakeThroughputPlots(const std::vector<BenchRow>& rows);
}

#endif

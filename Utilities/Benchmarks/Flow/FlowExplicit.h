// SPDX-License-Identifier: BSD-3-Clause
#ifndef FlowExplicit_h
#define FlowExplicit_h

#include "Benchmarks/Results/BenchPlot.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include <vector>

/**
 * The part of the suite `flow` about explicit flow volumes against implicit ones: table 4.1 of C.
 * Zhang, dissertation, Ohio State 2006, measured.
 */
namespace flow
{
/**
 * The cases of MakeTubes, by one thread. Methods, with their parameters:
 * - `explicit`, `explicit-halved`: ExplicitFlowVolume, without and with edges halved that grow
 *   beyond 1.5 times what they are on the disc; its rings, four layers for each;
 * - `implicit`: DiscVolume, from the field to the volume; samples along each side of a box behind
 *   the disc's plane;
 * - `implicit-again`: the same volume after a change of the inflow mapping;
 * - `implicit-refined`: as `implicit`, with two levels of refinement.
 */
void AddExplicitRows(const BenchOptions& options, BenchRows& rows);

/// Misplaced volume and the boundary's distance against run time, two plots for each case.
std::vector<BenchPlot> MakeExplicitPlots(const std::vector<BenchRow>& rows);
}

#endif

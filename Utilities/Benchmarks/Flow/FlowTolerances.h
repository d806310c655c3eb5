// SPDX-License-Identifier: BSD-3-Clause
#ifndef FlowTolerances_h
#define FlowTolerances_h

#include "Benchmarks/Results/BenchClaim.h"
#include "Benchmarks/Results/BenchPlot.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include <vector>

/**
 * The part of the suite `flow` about the error of (u,v,t) by integrator and tolerance.
 */
namespace flow
{
/**
 * The cases of FlowFields, by one thread. Methods: each integrator of vtkImplicitFlowField at each
 * tolerance, which is the parameter: MaximumError over the largest speed, but in fields that are
 * stiff MaximumError; and, where the field is not stiff, the peer's `RK4` by step in cells and
 * `RK45` by MaximumError.
 */
void AddToleranceRows(const BenchOptions& options, BenchRows& rows);

std::vector<BenchClaim> CheckToleranceClaims(const std::vector<BenchRow>& rows);
/// The errors of (u,v) and of t against run time, two plots for each case.
std::vector<BenchPlot> MakeTolerancePlots(const std::vector<BenchRow>& rows);
}

#endif

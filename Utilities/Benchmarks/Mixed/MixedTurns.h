// SPDX-License-Identifier: BSD-3-Clause
#ifndef MixedTurns_h
#define MixedTurns_h

#include "Benchmarks/Results/BenchClaim.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include <vector>

namespace mixed
{
/**
 * Pictures by vtkShadowedScenePass from views a degree apart, and under lights a degree apart, over
 * as many degrees as the parameter says, 360 in full runs. `views` and `lights`: the error is the
 * largest distance of a picture's mean from the middle of its neighbours', over the mean of all;
 * worst_frame is its place, p95 below which 95 % are. change_* is the same of the largest change of
 * a pixel's red from one picture to the next, as it is.
 */
void AddTurnRows(const BenchOptions& options, BenchRows& rows);
std::vector<BenchClaim> CheckTurnClaims(const std::vector<BenchRow>& rows);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef MixedSoft_h
#define MixedSoft_h

#include "Benchmarks/Results/BenchPlot.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include <vector>

namespace mixed
{
/**
 * Surfaces alone under a round vtkAreaLight by vtkShadowedScenePass, whose peer is the same light
 * without its extent; errors against the ray caster in double precision with 400 points of the
 * light. `soft`: the parameter is NumberOfLightSamples, the light moves from frame to frame and
 * over_hard is the time over the peer's. `hard`: the peer.
 */
void AddSoftRows(const BenchOptions& options, BenchRows& rows);
std::vector<BenchPlot> MakeSoftPlots(const std::vector<BenchRow>& rows);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef MixedError_h
#define MixedError_h

#include "Benchmarks/Results/BenchClaim.h"
#include "Benchmarks/Results/BenchPlot.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include <vector>

namespace mixed
{
/**
 * Pictures of boxes and slabs of smoke by vtkShadowedScenePass against the ray caster in double
 * precision. `scene-pass`: at its defaults; the count flat_p95 is the difference of red below which
 * 95 % of the pixels away from edges are. `edges`: with depth maps whose texels are four pixels
 * wide; edge_texels and edge_texels_largest are how far shadows' edges are from their places.
 */
void AddErrorRows(const BenchOptions& options, BenchRows& rows);
std::vector<BenchClaim> CheckErrorClaims(const std::vector<BenchRow>& rows);
std::vector<BenchPlot> MakeErrorPlots(const std::vector<BenchRow>& rows);
}

#endif

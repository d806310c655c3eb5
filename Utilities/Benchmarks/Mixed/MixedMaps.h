// SPDX-License-Identifier: BSD-3-Clause
#ifndef MixedMaps_h
#define MixedMaps_h

#include "Benchmarks/Results/BenchClaim.h"
#include "Benchmarks/Results/BenchPlot.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include <vector>

namespace mixed
{
/**
 * Surfaces alone under a spotlight, by vtkShadowedScenePass, whose peer is vtkShadowMapPass with
 * depth maps of the same resolution, the parameter; errors against the ray caster in double
 * precision. `scene-pass` and `shadow-maps`: only the camera moves; edge_pixels is how far shadows'
 * edges are from their places; over_peer, processor_over_peer and error_over_peer are ours over the
 * peer's. `scene-pass, light moves`: maps are drawn for each frame.
 */
void AddMapRows(const BenchOptions& options, BenchRows& rows);
std::vector<BenchClaim> CheckMapClaims(const std::vector<BenchRow>& rows);
std::vector<BenchPlot> MakeMapPlots(const std::vector<BenchRow>& rows);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef MixedCost_h
#define MixedCost_h

#include "Benchmarks/Results/BenchClaim.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include <vector>

namespace mixed
{
/**
 * Actors of a million triangles (the parameter) and a volume, by vtkShadowedScenePass: the peer is
 * the time of the volume alone and twice that of VTK drawing the actors, as for a depth map and the
 * picture. `scene-pass`: the camera moves and maps are kept; `scene-pass, light moves`: they are
 * drawn for each frame. over_budget is the time over the peer's, and
 * processor_over_budget the processor time of all threads over it.
 */
void AddCostRows(const BenchOptions& options, BenchRows& rows);
std::vector<BenchClaim> CheckCostClaims(const std::vector<BenchRow>& rows);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef TetrahedraError_h
#define TetrahedraError_h

#include "Benchmarks/Results/BenchPlot.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include <vector>

/**
 * The part of the suite `tetrahedra` about error against run time.
 */
namespace tetrahedra
{
/**
 * Pictures of meshes of several resolutions, by every render path and VTK's three mappers, against
 * the picture of the field without a mesh. The parameter is the number of cubes along an edge. Then
 * the coarser pictures of the level of detail: the parameter is the pixel stride.
 */
void AddErrorRows(const BenchOptions& options, BenchRows& rows);

/**
 * Error against time as the mesh gets finer.
 */
std::vector<BenchPlot> MakeErrorPlots(const std::vector<BenchRow>& rows);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef IntervalError_h
#define IntervalError_h

#include "Benchmarks/Results/BenchPlot.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include <vector>

/**
 * The part of the suite `interval` about error against run time.
 */
namespace interval
{
/**
 * Methods `hexahedra` (image data, as it is), `hexahedra-unstructured`, `tetrahedra-5`, `-6`, `-24`
 * (the cells split beforehand; the time to split is `split_seconds`) and `clip2`, on the analytic
 * cases. The parameter is the number of points along an axis. One row for each norm:
 * - `volume, relative`: of the volume of the exact trilinear region;
 * - `surface distance, rms, share of the domain's edge`: from the result's boundary inside the
 * domain to the exact trilinear surface;
 * - `volume, relative, with sampling`: of the volume of the analytic region, where it is known.
 */
void AddErrorRows(const BenchOptions& options, BenchRows& rows);

/**
 * Error against run time: one plot for each case and norm.
 */
std::vector<BenchPlot> MakeErrorPlots(const std::vector<BenchRow>& rows);
}

#endif

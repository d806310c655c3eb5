// SPDX-License-Identifier: BSD-3-Clause
#ifndef TetrahedraSpeed_h
#define TetrahedraSpeed_h

#include "Benchmarks/Results/BenchClaim.h"
#include "Benchmarks/Results/BenchPlot.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include <vector>

/**
 * The part of the suite `tetrahedra` about run time.
 */
namespace tetrahedra
{
/**
 * Methods `opengl` and `software`, the render paths, against the peer `projectedtetrahedra`: a row
 * for each blend, sort and integration mode, and rows with the exponent of time against tetrahedra.
 */
void AddSpeedRows(const BenchOptions& options, BenchRows& rows);

/**
 * What is wanted of these rows: ratios to the peer, unsorted modes faster, cost linear in
 * tetrahedra.
 */
std::vector<BenchClaim> CheckSpeedClaims(const std::vector<BenchRow>& rows);

/**
 * Time against tetrahedra, and bars of the ratio for each render path.
 */
std::vector<BenchPlot> MakeSpeedPlots(const std::vector<BenchRow>& rows);
}

#endif

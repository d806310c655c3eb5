// SPDX-License-Identifier: BSD-3-Clause
#ifndef IntervalOrientation_h
#define IntervalOrientation_h

#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

namespace interval
{
/**
 * Method `inverted`: which share of the tetrahedra is inverted, and which share of the volume they
 * hold (the error), on cells of each shape with random values and on real data.
 */
void AddOrientationRows(const BenchOptions& options, BenchRows& rows);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef IntervalSpeed_h
#define IntervalSpeed_h

#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

/**
 * The parts of the suite `interval` about run time.
 */
namespace interval
{
/**
 * Method `interval-volume`: against `clip2` and `clip2-tetrahedra`, by one thread and by all.
 */
void AddSpeedRows(const BenchOptions& options, BenchRows& rows);

/**
 * Method `threads-2`: two threads against the peer `threads-1`.
 */
void AddThreadRows(const BenchOptions& options, BenchRows& rows);

/**
 * Method `re-extract`: changed intervals with the value index, against the peer `all-cells` without
 * it, by one thread. The parameter is the width of the interval as a share of the range of values.
 */
void AddReExtractionRows(const BenchOptions& options, BenchRows& rows);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef SecondThread_h
#define SecondThread_h

#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

/**
 * Fills in the seconds of \a work by two threads, and by one as the peer `threads-1`.
 */
void MeasureSecondThread(const BenchWork& work, const BenchOptions& options, BenchRow& row);

#endif

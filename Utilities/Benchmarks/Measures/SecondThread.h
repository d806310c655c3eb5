// SPDX-License-Identifier: BSD-3-Clause
#ifndef SecondThread_h
#define SecondThread_h

#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Benchmarks/Suites/BenchOptions.h"

/**
 * Measures \a work with two threads and with one thread, and stores the times in \a row. One thread
 * is the baseline `threads-1`.
 */
void MeasureTwoThreads(const BenchWork& work, const BenchOptions& options, BenchRow& row);

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchTiming_h
#define BenchTiming_h

#include "Benchmarks/Measures/BenchSeconds.h"

#include "vtkAlgorithm.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

/**
 * Something to be timed. What it returns is kept until the clock is stopped, so that freeing a
 * result is not part of the time.
 */
using BenchWork = std::function<vtkSmartPointer<vtkObjectBase>()>;

/**
 * This moment, in seconds of std::chrono::steady_clock.
 */
double GetSteadySeconds();

/**
 * Wall seconds of one run of \a work.
 */
BenchSeconds TimeOnce(const BenchWork& work);

/**
 * Median wall seconds of each of \a works: each is run once unmeasured, then all take turns,
 * A B C A B C ..., \a repeats times, so that what else the machine does falls on all alike.
 */
std::vector<BenchSeconds> MeasureAlternately(const std::vector<BenchWork>& works, int repeats);

/**
 * \a work by so many threads of vtkSMPTools, which stays set so afterwards.
 */
BenchWork WithThreads(int threads, const BenchWork& work);

/**
 * Executes \a filter again, with its inputs as they are, by the threads that are set.
 */
BenchWork Again(const vtkSmartPointer<vtkAlgorithm>& filter);

/**
 * `1 thread`, `2 threads`, ...: the parameter of a row.
 */
std::string ThreadsParameter(int threads);

/**
 * The middle of \a numbers, or the mean of the two in the middle; 0 for none.
 */
double Median(std::vector<double> numbers);

/**
 * The median of the seconds of so many runs.
 */
BenchSeconds MedianOf(const std::vector<double>& runs);

/**
 * The median of single runs, with the spans of all.
 */
BenchSeconds MedianOf(const std::vector<BenchSeconds>& runs);

#endif

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
 * Work to be timed. Its result is held until the clock stops, so that the time excludes freeing it.
 */
using BenchWork = std::function<vtkSmartPointer<vtkObjectBase>()>;

/**
 * Returns the current time in seconds of std::chrono::steady_clock.
 */
double GetSteadySeconds();

/**
 * Returns the wall and processor time of one run of \a work.
 */
BenchSeconds TimeOnce(const BenchWork& work);

/**
 * Returns the median time of each of \a works. All are run once untimed, and then alternately, A B
 * C A B C ..., \a repeats times. Other activity on the machine thus affects all of them equally.
 */
std::vector<BenchSeconds> MeasureAlternately(const std::vector<BenchWork>& works, int repeats);

/**
 * Returns work that sets the number of threads of vtkSMPTools to \a threads and then runs \a work.
 * The number remains set afterward.
 */
BenchWork WithThreads(int threads, const BenchWork& work);

/**
 * Returns work that executes \a filter again with unchanged inputs.
 */
BenchWork MakeRerunWork(const vtkSmartPointer<vtkAlgorithm>& filter);

/**
 * Returns a row's parameter for the number of threads: `1 thread`, `2 threads`, ...
 */
std::string ThreadsParameter(int threads);

/**
 * Returns the median of \a numbers, or 0 if there are none.
 */
double Median(std::vector<double> numbers);

/**
 * Returns the median of the wall times \a runs, in seconds.
 */
BenchSeconds MedianOf(const std::vector<double>& runs);

/**
 * Returns the medians of the wall and processor times of \a runs, with the spans of all runs.
 */
BenchSeconds MedianOf(const std::vector<BenchSeconds>& runs);

#endif

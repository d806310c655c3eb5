// SPDX-License-Identifier: BSD-3-Clause
#ifndef ErrorFront_h
#define ErrorFront_h

#include "Benchmarks/Results/BenchPlot.h"

#include <optional>
#include <string>
#include <vector>

/**
 * What of a plot of errors against run times is worth choosing.
 */

/// A point of a plot: how it was made, what it costs, how wrong it is.
struct ErrorPoint
{
  std::string Series;
  /// Its setting; may be empty.
  std::string Name;
  double Cost = 0.0;
  double Error = 0.0;
};

/**
 * The Pareto front: the points of all series, peers too, than which no other has both a smaller
 * cost and an error that is not larger; by rising cost and falling error.
 */
std::vector<ErrorPoint> FindFront(const BenchPlot& plot);

/**
 * The cost of the default's point over that of the cheapest point whose error is not larger: 1 on
 * the front. Nothing without such a point.
 */
std::optional<double> GetCostOverFront(const BenchPlot& plot);

/**
 * The most of it at which the default counts as on the front: what medians of runs differ by.
 */
constexpr double FrontTolerance = 1.1;

/**
 * Whether the default is on the front, in one sentence with its error and cost and, where it is
 * not, those of the point that is cheaper and not worse. Empty without a default.
 */
std::string AnswerOf(const BenchPlot& plot);

#endif

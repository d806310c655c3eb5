// SPDX-License-Identifier: BSD-3-Clause
#ifndef ErrorFront_h
#define ErrorFront_h

#include "Benchmarks/Results/BenchPlot.h"

#include <optional>
#include <string>
#include <vector>

/**
 * Pareto front of a plot of error against run time.
 */

/// A point of a plot: series, setting, cost and error.
struct ErrorPoint
{
  std::string Series;
  /// Setting of the point; may be empty.
  std::string Name;
  double Cost = 0.0;
  double Error = 0.0;
};

/**
 * Returns the Pareto front of all series that are choices, including baselines, sorted by ascending
 * cost and descending error. A point is on the front if all other points have a larger cost or a
 * larger error.
 */
std::vector<ErrorPoint> FindParetoFront(const BenchPlot& plot);

/**
 * Returns the cost of the default divided by the cost of the cheapest point whose error is not
 * larger. The result is 1 if the default is on the front, and empty if the plot has no default.
 */
std::optional<double> GetCostRelativeToFront(const BenchPlot& plot);

/**
 * Largest result of GetCostRelativeToFront() for which the default still counts as on the front. It
 * allows for noise in the measured times.
 */
constexpr double FrontTolerance = 1.1;

/**
 * Returns a sentence that states whether the default is on the front, with its error and cost. If
 * the default is not on the front, the sentence names the point that dominates it. The sentence is
 * empty if the plot has no default.
 */
std::string SummaryOf(const BenchPlot& plot);

#endif

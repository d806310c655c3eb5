// SPDX-License-Identifier: BSD-3-Clause
#ifndef LegendCorner_h
#define LegendCorner_h

#include <array>

struct BenchPlot;

/**
 * A corner of a plot's frame.
 */
struct LegendCorner
{
  bool IsRight = true;
  bool IsTop = true;
};

/**
 * The corner where a legend hides least of the lines of \a plot, whose axes have the ranges \a x
 * and \a y: the top right where there is no better one.
 */
LegendCorner FindLegendCorner(
  const BenchPlot& plot, const std::array<double, 2>& x, const std::array<double, 2>& y);

#endif

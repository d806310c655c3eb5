// SPDX-License-Identifier: BSD-3-Clause
#ifndef PlotSvg_h
#define PlotSvg_h

#include "Benchmarks/Results/BenchPlot.h"

#include <cstddef>
#include <string>
#include <vector>

/// Number of distinct marks. Marks differ in shape, so that lines can be distinguished in black and
/// white.
constexpr std::size_t NumberOfMarks = 14;

/// Returns the SVG attributes of a series' mark: class, stroke, fill and path.
std::string MarkOf(std::size_t series);

/// Returns the color of a series as #rrggbb. The first five colors also differ in brightness, so
/// that bars can be distinguished in black and white.
std::string ColorOf(std::size_t series);

/**
 * Returns \a plot as an SVG image. Classes of elements: `line` for lines (dashed lines also have
 * the class `peer` or `no-choice`), `mark` for the marks of points, `bar` for bars, `default` for
 * rings around points of the default settings, and `front` for the Pareto front. Points that cannot
 * be drawn on a logarithmic axis are skipped.
 */
std::string MakeSvg(const BenchPlot& plot, const std::string& caption);

/**
 * Writes `<name>.svg` for each plot with points into \a folder, and returns these plots. Throws
 * std::runtime_error if a file cannot be written.
 */
std::vector<BenchPlot> WritePlots(
  const std::vector<BenchPlot>& plots, const std::string& folder, const std::string& caption);

#endif

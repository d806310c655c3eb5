// SPDX-License-Identifier: BSD-3-Clause
#ifndef PlotSvg_h
#define PlotSvg_h

#include "Benchmarks/Results/BenchPlot.h"

#include <cstddef>
#include <string>
#include <vector>

/// Number of distinct marks. Marks differ in shape, so that lines can be distinguished without
/// colors.
constexpr std::size_t NumberOfMarks = 14;

/// Returns the SVG attributes of the mark of a series: path and fill.
std::string MarkOf(std::size_t series);

/// Returns the color of a series, #rrggbb. The first five colors also differ in brightness, so that
/// bars can be distinguished without colors.
std::string ColorOf(std::size_t series);

/**
 * Returns \a plot as an SVG image. Elements have classes: `line` (also `peer` or `no-choice`, which
 * are dashed), `bar`, `default` for rings around points of the default settings, and `front` for
 * the Pareto front. Points that cannot be drawn on a logarithmic axis are skipped.
 */
std::string MakeSvg(const BenchPlot& plot, const std::string& caption);

/**
 * Writes `<name>.svg` for each plot with points into \a folder, and returns these plots. Throws
 * std::runtime_error if a file cannot be written.
 */
std::vector<BenchPlot> WritePlots(
  const std::vector<BenchPlot>& plots, const std::string& folder, const std::string& caption);

#endif

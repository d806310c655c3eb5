// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchPlot_h
#define BenchPlot_h

#include <string>
#include <vector>

/**
 * A plot to be drawn: lines with markers, or bars.
 */
struct BenchPlot
{
  struct Series
  {
    std::string Label;
    /// Peers are drawn dashed, and as hatched bars.
    bool IsPeer = false;
    std::vector<double> X;
    std::vector<double> Y;
  };

  enum Kinds
  {
    LINES,
    /// One group of bars for each of BarLabels; a series has its Y in their order.
    BARS
  };

  Kinds Kind = LINES;
  /// File name without its ending.
  std::string Name;
  std::string Title;
  /// With units.
  std::string XLabel;
  std::string YLabel;
  bool LogX = false;
  bool LogY = false;
  /// Whether lines end at the top right, so that the legend is better at the bottom.
  bool Rises = false;
  /// Label of the series whose points are ringed, as the default's.
  std::string DefaultSeries;
  /// Or the points that are, where a series holds others too.
  Series DefaultPoints;
  std::vector<std::string> BarLabels;
  /// Bars: height of a dashed line across, such as ratio 1; 0 for none.
  double Reference = 0.0;
  std::vector<Series> AllSeries;

  /// Adds a point to the series \a label, which is made where it is missing.
  void AddPoint(const std::string& label, bool isPeer, double x, double y);
};

#endif

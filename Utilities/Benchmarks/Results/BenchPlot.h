// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchPlot_h
#define BenchPlot_h

#include "Benchmarks/Results/BenchRow.h"

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
    /// Peers are drawn dashed.
    bool IsPeer = false;
    /// Whether it can be chosen for what the plot asks; else it is there for comparison, and in no
    /// front.
    bool IsChoice = true;
    std::vector<double> X;
    std::vector<double> Y;
    /// What is written beside each point, such as its setting; empty for nothing.
    std::vector<std::string> Names;
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
  /// What the plot answers, a sentence for the head of the report; empty for nothing.
  std::string Question;
  /// What was measured on what, in sentences for the caption.
  std::string Conditions;
  /// With units.
  std::string XLabel;
  std::string YLabel;
  bool LogX = false;
  bool LogY = false;
  /// Whether X is what something costs and Y how wrong it is, so that the points that no other is
  /// better than in both are a front, which is drawn: see ErrorFront.h.
  bool HasFront = false;
  /// The point that is ringed, what nobody has to ask for; or the series all of whose points are.
  Series DefaultPoint;
  std::string DefaultSeries;
  std::vector<std::string> BarLabels;
  /// Bars: height of a dashed line across, such as ratio 1; 0 for none.
  double Reference = 0.0;
  std::vector<Series> AllSeries;

  /// An error against run time, both on logarithmic axes, with its front.
  static BenchPlot OfErrors(const std::string& name, const std::string& title,
    const std::string& timeLabel, const std::string& errorLabel, const std::string& question = {},
    const std::string& conditions = {});

  /// Bars, one group for each label.
  static BenchPlot OfBars(
    const std::string& name, const std::string& title, const std::string& label);

  /// Adds a bar to the group of that label, which is appended if it is missing.
  void AddBar(const std::string& group, const std::string& label, bool isPeer, double height);

  /// Adds a point to the series \a label, which is made where it is missing.
  void AddPoint(const std::string& label, bool isPeer, double x, double y,
    const std::string& name = std::string());

  /// Adds the time and the error of \a row, named by its parameter, to the series \a label, by
  /// default the row's method. An error of 0 has no place on a logarithmic axis and is skipped.
  void AddRow(const BenchRow& row, bool isPeer, const std::string& label = {});

  /// Says that the series \a label, where it is, cannot be chosen.
  void SetNoChoice(const std::string& label);

  /// Rings the last point of the series \a label, or its point of that name; none where there is no
  /// such point.
  void SetDefault(const std::string& label, const std::string& name = std::string());
};

/// Returns the plot of the same name among \a plots, to which \a fresh is appended if it is
/// missing.
BenchPlot& FindOrAdd(std::vector<BenchPlot>& plots, const BenchPlot& fresh);

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchPlot_h
#define BenchPlot_h

#include "Benchmarks/Results/BenchRow.h"

#include <string>
#include <vector>

/**
 * A plot with lines and markers, or with bars.
 */
struct BenchPlot
{
  struct Series
  {
    std::string Label;
    /// Baselines are drawn dashed.
    bool IsBaseline = false;
    /// Whether the series is an answer to the plot's question. Otherwise it is drawn for comparison
    /// only and excluded from the Pareto front.
    bool IsChoice = true;
    std::vector<double> X;
    std::vector<double> Y;
    /// Labels of the points, such as settings. Labels may be empty.
    std::vector<std::string> Names;
  };

  enum Kinds
  {
    LINES,
    /// One group of bars for each entry of BarLabels. The Y values of a series are in the order of
    /// BarLabels.
    BARS
  };

  Kinds Kind = LINES;
  /// File name without extension.
  std::string Name;
  std::string Title;
  /// The question that the plot answers, shown at the top of the report. May be empty.
  std::string Question;
  /// Caption: sentences about the data and methods.
  std::string Conditions;
  /// Axis labels with units.
  std::string XLabel;
  std::string YLabel;
  bool LogX = false;
  bool LogY = false;
  /// Whether X is a cost and Y an error, so that a Pareto front is drawn (see ErrorFront.h).
  bool HasFront = false;
  /// The point of the default settings, or the series whose points all have default settings. Rings
  /// mark these points.
  Series DefaultPoint;
  std::string DefaultSeries;
  std::vector<std::string> BarLabels;
  /// Height of a dashed reference line in bar plots, such as ratio 1, or 0 for no line.
  double Reference = 0.0;
  std::vector<Series> AllSeries;

  /// Returns a plot of error against run time with logarithmic axes and a Pareto front.
  static BenchPlot OfErrors(const std::string& name, const std::string& title,
    const std::string& timeLabel, const std::string& errorLabel, const std::string& question = {},
    const std::string& conditions = {});

  /// Returns a bar plot without bars. \a label is the label of the y axis.
  static BenchPlot MakeBarPlot(
    const std::string& name, const std::string& title, const std::string& label);

  /// Adds a bar of the series \a label to the group \a group. Creates the series and the group if
  /// they do not exist.
  void AddBar(const std::string& group, const std::string& label, bool isBaseline, double height);

  /// Adds a point to the series \a label, which is created if it does not exist.
  void AddPoint(const std::string& label, bool isBaseline, double x, double y,
    const std::string& name = std::string());

  /// Adds the time and error of \a row as a point of the series \a label, by default the row's
  /// method. The row's parameter labels the point. Errors of 0 are skipped, since the axis is
  /// logarithmic.
  void AddRow(const BenchRow& row, bool isBaseline, const std::string& label = {});

  /// Sets IsChoice of the series \a label to false, if the series exists.
  void ExcludeFromFront(const std::string& label);

  /// Marks a point of the series \a label as the default: the point named \a name, or the last one
  /// if \a name is empty. If there is no such point, no point is marked.
  void SetDefault(const std::string& label, const std::string& name = std::string());
};

/// Returns the plot in \a plots with the name of \a fresh. If there is none, appends \a fresh and
/// returns it.
BenchPlot& FindOrAdd(std::vector<BenchPlot>& plots, const BenchPlot& fresh);

#endif

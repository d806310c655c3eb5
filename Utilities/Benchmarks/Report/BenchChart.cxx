// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Report/BenchChart.h"

#include "Benchmarks/Report/LegendCorner.h"
#include "Benchmarks/Report/MarkedLine.h"
#include "Benchmarks/Report/PointNames.h"
#include "Benchmarks/Results/BenchPlot.h"
#include "Benchmarks/Results/ErrorFront.h"

#include "vtkAxis.h"
#include "vtkBrush.h"
#include "vtkChartLegend.h"
#include "vtkChartXY.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPen.h"
#include "vtkPlotBar.h"
#include "vtkPlotLine.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace
{
/// Their greys are well apart from one to the next, and among the first five, which bars have,
/// altogether.
const std::array<unsigned char, 3> Colours[] = { { { 68, 1, 84 } }, { { 0, 92, 150 } },
  { { 220, 80, 30 } }, { { 85, 185, 140 } }, { { 245, 180, 60 } }, { { 90, 90, 90 } },
  { { 190, 110, 190 } }, { { 20, 100, 60 } }, { { 90, 150, 200 } }, { { 110, 60, 20 } } };

const std::array<unsigned char, 3>& ColourOf(std::size_t series)
{
  return Colours[series % (sizeof(Colours) / sizeof(Colours[0]))];
}

vtkSmartPointer<vtkTable> MakeTable(
  const std::string& label, const std::vector<double>& x, const std::vector<double>& y)
{
  auto table = vtkSmartPointer<vtkTable>::New();
  const std::pair<std::string, const std::vector<double>&> columns[] = { { "x", x }, { label, y } };
  for (const auto& column : columns)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(column.first.c_str());
    for (double value : column.second)
    {
      array->InsertNextValue(value);
    }
    table->AddColumn(array);
  }
  return table;
}

vtkSmartPointer<vtkTable> MakeTable(const BenchPlot::Series& series)
{
  // A line of one point is an error to VTK's charts.
  const std::size_t copies = series.X.size() == 1 ? 2 : 1;
  std::vector<double> x;
  std::vector<double> y;
  for (std::size_t i = 0; i < copies; ++i)
  {
    x.insert(x.end(), series.X.begin(), series.X.end());
    y.insert(y.end(), series.Y.begin(), series.Y.end());
  }
  return MakeTable(series.Label, x, y);
}

/// The range of the numbers of every series, none negative, widened so that no marker touches the
/// frame and the legend has room.
std::array<double, 2> RangeOf(
  const BenchPlot& plot, std::vector<double> BenchPlot::Series::*numbers, bool logarithmic)
{
  double low = std::numeric_limits<double>::max();
  double high = plot.Reference;
  for (const BenchPlot::Series& series : plot.AllSeries)
  {
    for (double number : series.*numbers)
    {
      if (!logarithmic || number > 0.0)
      {
        low = std::min(low, number);
        high = std::max(high, number);
      }
    }
  }
  if (logarithmic)
  {
    // Whole decades: the axis then has a labelled tick at both ends.
    return { std::pow(10.0, std::floor(std::log10(low) - 0.05)),
      std::pow(10.0, std::ceil(std::log10(high) + 0.05)) };
  }
  return { 0.0, 1.2 * high };
}

void SetAxis(vtkAxis* axis, const std::string& label, bool logarithmic)
{
  axis->SetTitle(label);
  axis->GetTitleProperties()->SetFontSize(22);
  axis->GetTitleProperties()->SetBold(false);
  axis->GetLabelProperties()->SetFontSize(19);
  axis->GetGridPen()->SetColor(225, 225, 225, 255);
  axis->SetLogScale(logarithmic);
}

void SetRange(vtkAxis* axis, const std::array<double, 2>& range, bool logarithmic)
{
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetUnscaledRange(range[0], range[1]);
  if (!logarithmic)
  {
    return;
  }
  vtkNew<vtkDoubleArray> positions;
  vtkNew<vtkStringArray> labels;
  const int first = static_cast<int>(std::lround(std::log10(range[0])));
  const int last = static_cast<int>(std::lround(std::log10(range[1])));
  const int step = std::max(1, (last - first + 7) / 8);
  for (int decade = first; decade <= last; decade += step)
  {
    positions->InsertNextValue(decade);
    labels->InsertNextValue("1e" + std::to_string(decade));
  }
  axis->SetCustomTickPositions(positions, labels);
}

void AddDiscs(vtkChartXY* chart, vtkTable* table, unsigned char grey, float size, bool isNamed)
{
  auto disc = vtkPlotLine::SafeDownCast(chart->AddPlot(vtkChart::LINE));
  disc->SetInputData(table, 0, 1);
  disc->SetColor(grey, grey, grey, 255);
  disc->GetPen()->SetLineType(vtkPen::NO_PEN);
  disc->SetMarkerStyle(vtkPlotPoints::CIRCLE);
  disc->SetMarkerSize(size);
  disc->SetLabel("default");
  disc->SetLegendVisibility(isNamed);
}

/// Around the points of the default, which are drawn later.
void AddRings(vtkChartXY* chart, vtkTable* table)
{
  AddDiscs(chart, table, 0, 34.0f, true);
  AddDiscs(chart, table, 255, 28.0f, false);
}

/// The front as stairs: what is above and right of them is worse than a point that there is.
void AddFront(vtkChartXY* chart, const BenchPlot& plot)
{
  std::vector<double> x;
  std::vector<double> y;
  for (const ErrorPoint& point : FindFront(plot))
  {
    if (!x.empty())
    {
      x.push_back(point.Cost);
      y.push_back(y.back());
    }
    x.push_back(point.Cost);
    y.push_back(point.Error);
  }
  if (x.size() > 1)
  {
    auto stairs = vtkPlotLine::SafeDownCast(chart->AddPlot(vtkChart::LINE));
    stairs->SetInputData(MakeTable("Pareto front", x, y), 0, 1);
    stairs->SetColor(150, 150, 150, 255);
    stairs->GetPen()->SetLineType(vtkPen::DOT_LINE);
    stairs->SetWidth(5.0f);
    stairs->SetLabel("Pareto front");
  }
}

void AddLine(
  vtkChartXY* chart, const BenchPlot::Series& series, std::size_t position, bool isDefault)
{
  auto table = MakeTable(series);
  if (isDefault)
  {
    AddRings(chart, table);
  }
  vtkNew<MarkedLine> line;
  chart->AddPlot(line);
  line->SetInputData(table, 0, 1);
  line->SetLook(position, ColourOf(position));
  line->GetPen()->SetLineType(!series.IsChoice ? vtkPen::DASH_DOT_LINE
      : series.IsPeer                          ? vtkPen::DASH_LINE
                                               : vtkPen::SOLID_LINE);
  line->SetWidth(series.IsPeer ? 2.5f : 3.0f);
  line->SetLabel(!series.IsChoice ? series.Label + " (no choice)"
      : series.IsPeer             ? series.Label + " (peer)"
                                  : series.Label);
}

void AddReference(vtkChartXY* chart, double height, double first, double last)
{
  auto line = vtkPlotLine::SafeDownCast(chart->AddPlot(vtkChart::LINE));
  line->SetInputData(MakeTable("reference", { first, last }, { height, height }), 0, 1);
  line->SetColor(0, 0, 0, 255);
  line->GetPen()->SetLineType(vtkPen::DASH_LINE);
  line->SetWidth(1.5f);
  line->SetLegendVisibility(false);
}

void AddBars(vtkChartXY* chart, const BenchPlot& plot)
{
  const std::size_t groups = plot.BarLabels.size();
  std::vector<double> positions(groups);
  vtkNew<vtkDoubleArray> ticks;
  vtkNew<vtkStringArray> labels;
  for (std::size_t i = 0; i < groups; ++i)
  {
    positions[i] = static_cast<double>(i);
    ticks->InsertNextValue(positions[i]);
    labels->InsertNextValue(plot.BarLabels[i]);
  }
  for (std::size_t i = 0; i < plot.AllSeries.size(); ++i)
  {
    const BenchPlot::Series& series = plot.AllSeries[i];
    auto bars = vtkPlotBar::SafeDownCast(chart->AddPlot(vtkChart::BAR));
    bars->SetInputData(MakeTable(series.Label, positions, series.Y), 0, 1);
    const std::array<unsigned char, 3>& colour = ColourOf(i);
    bars->SetColor(colour[0], colour[1], colour[2], 255);
    bars->SetLabel(series.Label);
  }
  vtkAxis* bottom = chart->GetAxis(vtkAxis::BOTTOM);
  bottom->SetBehavior(vtkAxis::FIXED);
  bottom->SetUnscaledRange(-0.6, static_cast<double>(groups) - 0.4);
  bottom->SetCustomTickPositions(ticks, labels);
  bottom->SetGridVisible(false);
  if (plot.Reference > 0.0)
  {
    AddReference(chart, plot.Reference, -0.6, static_cast<double>(groups) - 0.4);
  }
}
}

void FillChart(vtkChartXY* chart, const BenchPlot& plot)
{
  chart->SetTitle(plot.Title);
  chart->GetTitleProperties()->SetFontSize(24);
  SetAxis(chart->GetAxis(vtkAxis::BOTTOM), plot.XLabel, plot.LogX);
  SetAxis(chart->GetAxis(vtkAxis::LEFT), plot.YLabel, plot.LogY);
  chart->SetShowLegend(true);
  chart->GetLegend()->GetLabelProperties()->SetFontSize(18);
  chart->GetLegend()->GetBrush()->SetColor(255, 255, 255, 230);
  const std::array<double, 2> y = RangeOf(plot, &BenchPlot::Series::Y, plot.LogY);
  SetRange(chart->GetAxis(vtkAxis::LEFT), y, plot.LogY);
  if (plot.Kind == BenchPlot::BARS)
  {
    AddBars(chart, plot);
    return;
  }
  const std::array<double, 2> x = RangeOf(plot, &BenchPlot::Series::X, plot.LogX);
  SetRange(chart->GetAxis(vtkAxis::BOTTOM), x, plot.LogX);
  const LegendCorner corner = FindLegendCorner(plot, x, y);
  chart->GetLegend()->SetHorizontalAlignment(
    corner.IsRight ? vtkChartLegend::RIGHT : vtkChartLegend::LEFT);
  chart->GetLegend()->SetVerticalAlignment(
    corner.IsTop ? vtkChartLegend::TOP : vtkChartLegend::BOTTOM);
  if (plot.HasFront)
  {
    AddFront(chart, plot);
  }
  if (!plot.DefaultPoint.X.empty())
  {
    AddRings(chart, MakeTable(plot.DefaultPoint));
  }
  for (std::size_t i = 0; i < plot.AllSeries.size(); ++i)
  {
    const BenchPlot::Series& series = plot.AllSeries[i];
    AddLine(chart, series, i, series.Label == plot.DefaultSeries);
  }
  vtkNew<PointNames> names;
  names->SetPlot(plot);
  chart->AddItem(names);
}

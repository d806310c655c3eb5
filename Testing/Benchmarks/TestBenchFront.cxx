// SPDX-License-Identifier: BSD-3-Clause
// Fronts, defaults and answers of plots that are made up, and what charts show of them.
#include "Benchmarks/Approximations/Approximation.h"
#include "Benchmarks/Report/BenchChart.h"
#include "Benchmarks/Report/MarkedLine.h"
#include "Benchmarks/Report/PlotMarks.h"
#include "Benchmarks/Results/ErrorFront.h"

#include "vtkAxis.h"
#include "vtkBrush.h"
#include "vtkChartLegend.h"
#include "vtkChartXY.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPen.h"
#include "vtkPlot.h"
#include "vtkPlotBar.h"
#include "vtkTable.h"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

namespace
{
bool Right = true;

void Expect(bool condition, const std::string& what)
{
  if (!condition)
  {
    std::cerr << "ERROR: " << what << std::endl;
    Right = false;
  }
}

/// A method that is cheap and wrong, one that is dear and right, a peer that is worse in both than
/// a point of ours, and one point that costs as much as another and is wronger.
BenchPlot MakePlot()
{
  BenchPlot plot = BenchPlot::OfErrors("made-up", "Made up", "run time (s)", "error");
  plot.AddPoint("fine", false, 4.0, 1e-4, "8");
  plot.AddPoint("fine", false, 8.0, 1e-5, "16");
  plot.AddPoint("coarse", false, 1.0, 1e-2, "1");
  plot.AddPoint("coarse", false, 2.0, 1e-3, "2");
  plot.AddPoint("coarse", false, 2.0, 2e-3, "2, again");
  plot.AddPoint("peer", true, 5.0, 5e-4);
  return plot;
}

void CheckFront()
{
  const std::vector<ErrorPoint> front = FindFront(MakePlot());
  Expect(front.size() == 4, "a front of " + std::to_string(front.size()) + " points");
  const char* names[] = { "1", "2", "8", "16" };
  for (std::size_t i = 0; i < front.size() && i < 4; ++i)
  {
    Expect(front[i].Name == names[i], "point " + front[i].Name + " of the front");
  }
  BenchPlot plot = MakePlot();
  plot.AddPoint("exact", false, 0.5, 1e-6);
  Expect(FindFront(plot).size() == 1, "what is best in both is the front");
  plot.SetNoChoice("exact");
  plot.SetNoChoice("nothing");
  Expect(FindFront(plot).size() == 4, "what nobody can choose is in no front");
  Expect(FindFront(BenchPlot()).empty(), "a front of nothing");
}

void CheckAnswers()
{
  BenchPlot plot = MakePlot();
  Expect(!GetCostOverFront(plot) && AnswerOf(plot).empty(), "an answer without a default");
  plot.SetDefault("fine", "8");
  Expect(GetCostOverFront(plot) == 1.0, "8 is on the front");
  Expect(AnswerOf(plot) == "The default, fine 8 (error 0.0001 in 4 s), is on the front.",
    "answer: " + AnswerOf(plot));
  plot.SetDefault("peer");
  Expect(GetCostOverFront(plot) == 1.25, "the peer costs 5 / 4 of 8");
  Expect(AnswerOf(plot) ==
      "The default, peer (error 0.0005 in 5 s), is not on the front: fine 8 has error 0.0001 in 4 "
      "s.",
    "answer: " + AnswerOf(plot));
  plot.AddPoint("near", false, 4.3, 1e-4, "9");
  plot.SetDefault("near");
  Expect(
    AnswerOf(plot).find("is within what runs differ by on the front: fine 8") != std::string::npos,
    "answer: " + AnswerOf(plot));
  plot.SetDefault("fine");
  Expect(plot.DefaultPoint.Names == std::vector<std::string>{ "16" }, "the last point of a series");
  plot.SetDefault("fine", "32");
  Expect(plot.DefaultPoint.X.empty(), "a default that is not there");
}

approximations::Question MakeQuestion()
{
  return { "made-up", "Made up", "Is it right?", "Made up.", "run time (s)", "error" };
}

/// What the rows of a question say of its plot.
void CheckRows()
{
  using namespace approximations;
  const Question question = MakeQuestion();
  Trials trials;
  trials.SetSize("cells along an edge", 8);
  int runs = 0;
  const auto work = [&runs]()
  {
    ++runs;
    return vtkSmartPointer<vtkObjectBase>();
  };
  trials.Add("own", "1", Maker::Own, work, []() { return 0.5; });
  trials.Add("own", "2", Maker::Default, work, []() { return 0.25; });
  trials.Add("other", "", Maker::Peer, work, []() { return 0.125; });
  trials.Add("exact", "", Maker::Own, work, []() { return 0.0; });
  BenchOptions options;
  options.Size = BenchOptions::TINY;
  BenchRows rows("suite");
  trials.Run(question, options, rows);
  Expect(rows.Get().size() == 4 && runs == 4 * (1 + options.GetRepeats()), "rows and runs");
  Expect(*rows.Get()[1].Error == 0.25 && rows.Get()[1].ErrorNorm == "error", "a row's error");

  const BenchPlot plot = approximations::MakePlot(question, rows.Get());
  Expect(plot.HasFront && plot.Question == question.Text, "the plot is the question's");
  Expect(plot.Conditions == "Made up. cells along an edge 8.", "caption: " + plot.Conditions);
  Expect(plot.AllSeries.size() == 2, "an error of 0 has no place");
  Expect(plot.AllSeries[1].IsPeer && !plot.AllSeries[0].IsPeer, "the peer is one");
  Expect(plot.DefaultPoint.Label == "own" && plot.DefaultPoint.Y == std::vector<double>{ 0.25 },
    "the default is ringed");

  const Family family = { question, nullptr };
  Expect(CheckDefaults({ family }, rows.Get()).Cases.size() == 1, "one claim");
  Expect(CheckDefaults({ family }, {}).Cases.empty(), "no claim without rows");
}

/// Times are the processor's where that is asked for: what waits takes none.
void CheckClocks()
{
  using namespace approximations;
  const Question question = MakeQuestion();
  Trials trials;
  trials.SetSize("cells along an edge", 8);
  const auto wait = []()
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(40));
    return vtkSmartPointer<vtkObjectBase>();
  };
  trials.Add("own", "1", Maker::Default, wait, []() { return 0.5; });
  BenchOptions options;
  options.Size = BenchOptions::TINY;
  for (const Clock clock : { Clock::Wall, Clock::Processor })
  {
    BenchRows rows("suite");
    trials.Run(question, options, rows, clock);
    const bool isProcessor = clock == Clock::Processor;
    Expect(*rows.Get()[0].Seconds >= 0.04, "seconds are those on the wall");
    const BenchPlot plot = approximations::MakePlot(question, rows.Get());
    Expect(isProcessor == (plot.AllSeries.at(0).X.at(0) < 0.02), "the plot has those of its clock");
    Expect(plot.XLabel == (isProcessor ? "processor run time (s)" : "run time (s)"),
      "axis: " + plot.XLabel);
    Expect(plot.Conditions ==
        (isProcessor ? "Made up. cells along an edge 8. Times are the processor's, of all threads."
                     : "Made up. cells along an edge 8."),
      "caption: " + plot.Conditions);
  }
  Expect(ClockOf(nullptr) == Clock::Wall, "no window is no software OpenGL");
}

/// The plots of a chart with that label, and the points of the last one.
int CountLabels(vtkChartXY* chart, const std::string& label, vtkIdType& points)
{
  int number = 0;
  for (vtkIdType i = 0; i < chart->GetNumberOfPlots(); ++i)
  {
    if (chart->GetPlot(i)->GetLabel() == label)
    {
      ++number;
      points = chart->GetPlot(i)->GetInput()->GetNumberOfRows();
    }
  }
  return number;
}

void CheckChart()
{
  BenchPlot plot = MakePlot();
  vtkNew<vtkChartXY> plain;
  FillChart(plain, plot);
  vtkIdType points = 0;
  Expect(CountLabels(plain, "default", points) == 0, "a ring around nothing");
  Expect(CountLabels(plain, "Pareto front", points) == 1 && points == 7,
    "the front is stairs of 7 points: " + std::to_string(points));
  Expect(CountLabels(plain, "peer (peer)", points) == 1, "the peer is called one");

  plot.SetDefault("fine", "8");
  vtkNew<vtkChartXY> chart;
  FillChart(chart, plot);
  // A disc, and a smaller one of the ground's colour on it.
  Expect(CountLabels(chart, "default", points) == 2, "the default is ringed");
  Expect(
    chart->GetAxis(vtkAxis::LEFT)->GetLogScale() && chart->GetAxis(vtkAxis::BOTTOM)->GetLogScale(),
    "both axes are logarithmic");

  plot.HasFront = false;
  vtkNew<vtkChartXY> without;
  FillChart(without, plot);
  Expect(CountLabels(without, "Pareto front", points) == 0, "a front that was not asked for");
}

/// A plot of as many series as are asked for, which are alike but for their labels.
BenchPlot MakeManySeries(std::size_t number, BenchPlot::Kinds kind)
{
  BenchPlot plot = BenchPlot::OfErrors("many", "Many", "run time (s)", "error");
  plot.Kind = kind;
  plot.LogX = kind == BenchPlot::LINES;
  plot.BarLabels = { "case" };
  for (std::size_t i = 0; i < number; ++i)
  {
    plot.AddPoint("series " + std::to_string(i), false, 1.0, 1.0);
  }
  return plot;
}

double GreyOf(const unsigned char* colour)
{
  return 0.299 * colour[0] + 0.587 * colour[1] + 0.114 * colour[2];
}

/// Whether each pixel of a mark is inked: what is left of it whatever its colour.
std::vector<bool> FindInk(vtkImageData* mark)
{
  std::vector<bool> ink(static_cast<std::size_t>(mark->GetNumberOfPoints()));
  const auto* pixel = static_cast<const unsigned char*>(mark->GetScalarPointer());
  for (std::size_t i = 0; i < ink.size(); ++i, pixel += 4)
  {
    ink[i] = pixel[3] > 127 && GreyOf(pixel) < 220.0;
  }
  return ink;
}

/// The share of pixels where one mark is inked and the other is not, of those where either is.
double CompareInk(const std::vector<bool>& one, const std::vector<bool>& other)
{
  int either = 0;
  int differ = 0;
  for (std::size_t i = 0; i < one.size(); ++i)
  {
    either += one[i] || other[i] ? 1 : 0;
    differ += one[i] != other[i] ? 1 : 0;
  }
  return static_cast<double>(differ) / either;
}

/// The legend stands where no lines are: of lines that rise not at the top right, of lines that end
/// in two corners in a third.
void CheckLegend()
{
  BenchPlot plot;
  plot.LogX = plot.LogY = true;
  const auto stands = [&plot](int horizontal, int vertical)
  {
    vtkNew<vtkChartXY> chart;
    FillChart(chart, plot);
    return chart->GetLegend()->GetHorizontalAlignment() == horizontal &&
      chart->GetLegend()->GetVerticalAlignment() == vertical;
  };
  plot.AddPoint("fall", false, 1.5, 800.0);
  plot.AddPoint("fall", false, 800.0, 1.5);
  Expect(stands(vtkChartLegend::RIGHT, vtkChartLegend::TOP), "above lines that fall");
  plot.AddPoint("rise", false, 1.5, 1.5);
  plot.AddPoint("rise", false, 800.0, 800.0);
  plot.AddPoint("again", false, 800.0, 800.0);
  plot.AddPoint("again", false, 800.0, 1.5);
  Expect(stands(vtkChartLegend::LEFT, vtkChartLegend::TOP), "beside lines on the right");
  plot.AllSeries.erase(plot.AllSeries.begin());
  plot.AllSeries.pop_back();
  Expect(stands(vtkChartLegend::RIGHT, vtkChartLegend::BOTTOM), "below lines that rise");
}

/// Series are told apart without colours: lines by their marks' shapes, bars by their greys.
void CheckGreys()
{
  vtkNew<vtkChartXY> chart;
  FillChart(chart, MakeManySeries(NumberOfMarks, BenchPlot::LINES));
  std::vector<std::vector<bool>> inks;
  for (vtkIdType i = 0; i < chart->GetNumberOfPlots(); ++i)
  {
    if (auto* line = MarkedLine::SafeDownCast(chart->GetPlot(i)))
    {
      inks.push_back(FindInk(line->GetMark()));
    }
  }
  Expect(inks.size() == NumberOfMarks && inks.size() >= 12, "each series is a line with marks");
  for (std::size_t i = 0; i < inks.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const double share = CompareInk(inks[i], inks[j]);
      Expect(share > 0.25,
        "marks " + std::to_string(j) + " and " + std::to_string(i) + " differ in " +
          std::to_string(share) + " of their ink");
    }
  }

  constexpr std::size_t most = 5;
  vtkNew<vtkChartXY> bars;
  FillChart(bars, MakeManySeries(most, BenchPlot::BARS));
  std::vector<double> greys;
  for (vtkIdType i = 0; i < bars->GetNumberOfPlots(); ++i)
  {
    if (auto* bar = vtkPlotBar::SafeDownCast(bars->GetPlot(i)))
    {
      unsigned char colour[4];
      bar->GetBrush()->GetColor(colour);
      greys.push_back(GreyOf(colour));
    }
  }
  Expect(greys.size() == most, "each series has bars");
  for (std::size_t i = 0; i < greys.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      Expect(std::abs(greys[i] - greys[j]) > 30.0,
        "bars " + std::to_string(j) + " and " + std::to_string(i) + " are greys of " +
          std::to_string(greys[j]) + " and " + std::to_string(greys[i]));
    }
  }
}

/// Peers, and what nobody can choose, are told from what is ours by their lines.
void CheckDashes()
{
  BenchPlot plot = MakeManySeries(3, BenchPlot::LINES);
  plot.AllSeries[1].IsPeer = true;
  plot.SetNoChoice("series 2");
  vtkNew<vtkChartXY> chart;
  FillChart(chart, plot);
  std::vector<int> dashes;
  for (vtkIdType i = 0; i < chart->GetNumberOfPlots(); ++i)
  {
    if (auto* line = MarkedLine::SafeDownCast(chart->GetPlot(i)))
    {
      dashes.push_back(line->GetPen()->GetLineType());
    }
  }
  Expect(dashes == std::vector<int>{ vtkPen::SOLID_LINE, vtkPen::DASH_LINE, vtkPen::DASH_DOT_LINE },
    "lines of ours, a peer and what is no choice");
}
}

int main()
{
  CheckFront();
  CheckAnswers();
  CheckRows();
  CheckClocks();
  CheckChart();
  CheckLegend();
  CheckGreys();
  CheckDashes();
  return Right ? EXIT_SUCCESS : EXIT_FAILURE;
}

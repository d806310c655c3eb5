// SPDX-License-Identifier: BSD-3-Clause
// Tests Pareto fronts, defaults and summaries of synthetic plots, and their SVG images.
#include "Benchmarks/Approximations/Approximation.h"
#include "Benchmarks/Report/PlotSvg.h"
#include "Benchmarks/Results/ErrorFront.h"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace
{
bool Success = true;

void Expect(bool condition, const std::string& what)
{
  if (!condition)
  {
    std::cerr << "ERROR: " << what << std::endl;
    Success = false;
  }
}

/// Returns a plot with a fast, inaccurate method ("coarse") and a slow, accurate method ("fine"). A
/// point of "fine" dominates the baseline. One point of "coarse" costs the same as another point
/// but has a larger error.
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
  const std::vector<ErrorPoint> front = FindParetoFront(MakePlot());
  Expect(front.size() == 4, "the front has 4 points, not " + std::to_string(front.size()));
  const char* names[] = { "1", "2", "8", "16" };
  for (std::size_t i = 0; i < front.size() && i < 4; ++i)
  {
    Expect(front[i].Name == names[i], "point on the front is " + front[i].Name);
  }
  BenchPlot plot = MakePlot();
  plot.AddPoint("exact", false, 0.5, 1e-6);
  Expect(FindParetoFront(plot).size() == 1, "a point that is best in both is the front");
  plot.ExcludeFromFront("exact");
  plot.ExcludeFromFront("nothing");
  Expect(FindParetoFront(plot).size() == 4, "points that cannot be chosen are not on the front");
  Expect(FindParetoFront(BenchPlot()).empty(), "an empty plot has no front");
}

void CheckSummaries()
{
  BenchPlot plot = MakePlot();
  Expect(!GetCostRelativeToFront(plot) && SummaryOf(plot).empty(),
    "without a default the sentence is empty");
  plot.SetDefault("fine", "8");
  Expect(GetCostRelativeToFront(plot) == 1.0, "8 is on the front");
  Expect(SummaryOf(plot) == "The default, fine 8 (error 0.0001 in 4 s), is on the front.",
    "summary: " + SummaryOf(plot));
  plot.SetDefault("peer");
  Expect(GetCostRelativeToFront(plot) == 1.25, "the baseline costs 5 / 4 of point 8");
  Expect(SummaryOf(plot) ==
      "The default, peer (error 0.0005 in 5 s), is not on the front: fine 8 has error 0.0001 in 4 "
      "s.",
    "summary: " + SummaryOf(plot));
  plot.AddPoint("near", false, 4.3, 1e-4, "9");
  plot.SetDefault("near");
  Expect(SummaryOf(plot).find("is within the measurement noise of the front: fine 8") !=
      std::string::npos,
    "summary: " + SummaryOf(plot));
  plot.SetDefault("fine");
  Expect(plot.DefaultPoint.Names == std::vector<std::string>{ "16" },
    "the default is the last point of a series");
  plot.SetDefault("fine", "32");
  Expect(plot.DefaultPoint.X.empty(), "an unknown default has no point");
}

approximations::Question MakeQuestion()
{
  return { "made-up", "Made up", "Is it right?", "Made up.", "run time (s)", "error" };
}

/// Checks the plot, caption and claim that are made from benchmark rows.
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
  trials.Add("other", "", Maker::Baseline, work, []() { return 0.125; });
  trials.Add("exact", "", Maker::Own, work, []() { return 0.0; });
  BenchOptions options;
  options.Size = BenchOptions::TINY;
  BenchRows rows("suite");
  trials.Run(question, options, rows);
  Expect(
    rows.Get().size() == 4 && runs == 4 * (1 + options.GetRepeats()), "number of rows and of runs");
  Expect(*rows.Get()[1].Error == 0.25 && rows.Get()[1].ErrorNorm == "error",
    "the row has the error and its norm");

  const BenchPlot plot = approximations::MakePlot(question, rows.Get());
  Expect(plot.HasFront && plot.Question == question.Text, "the plot is the question's");
  Expect(plot.Conditions == "Made up. cells along an edge 8.", "caption: " + plot.Conditions);
  Expect(plot.AllSeries.size() == 2, "an error of 0 is not plotted");
  Expect(plot.AllSeries[1].IsBaseline && !plot.AllSeries[0].IsBaseline,
    "only the baseline is marked as a baseline");
  Expect(plot.DefaultPoint.Label == "own" && plot.DefaultPoint.Y == std::vector<double>{ 0.25 },
    "the default is marked");

  const Family family = { question, nullptr };
  Expect(CheckDefaults({ family }, rows.Get()).Cases.size() == 1, "one claim per question");
  Expect(CheckDefaults({ family }, {}).Cases.empty(), "without rows the claim has no cases");
}

/// Checks that CPU time, if selected, excludes the time spent waiting.
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
    Expect(*rows.Get()[0].Seconds >= 0.04, "the row has the wall-clock time");
    const BenchPlot plot = approximations::MakePlot(question, rows.Get());
    Expect(
      isProcessor == (plot.AllSeries.at(0).X.at(0) < 0.02), "the plot uses the selected clock");
    Expect(plot.XLabel == (isProcessor ? "processor run time (s)" : "run time (s)"),
      "axis: " + plot.XLabel);
    Expect(plot.Conditions ==
        (isProcessor ? "Made up. cells along an edge 8. Times are the processor's, of all threads."
                     : "Made up. cells along an edge 8."),
      "caption: " + plot.Conditions);
  }
  Expect(SelectClock(nullptr) == Clock::Wall, "without a window the wall clock is used");
}

int Count(const std::string& text, const std::string& part)
{
  int number = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
  {
    ++number;
  }
  return number;
}

/// Returns true if each "<" is followed by ">" before the next "<", and all text elements are
/// closed.
bool IsWellFormed(const std::string& svg)
{
  bool isInside = false;
  for (const char character : svg)
  {
    if ((character == '<' && isInside) || (character == '>' && !isInside))
    {
      return false;
    }
    isInside = character == '<' || (isInside && character != '>');
  }
  return !isInside && Count(svg, "<text") == Count(svg, "</text>");
}

void CheckImage()
{
  BenchPlot plot = MakePlot();
  const std::string plain = MakeSvg(plot, "machine\nconditions");
  Expect(Count(plain, "class=\"default\"") == 0, "without a default nothing is marked");
  // The step function starts at the first of the four points and has a step to each other point.
  const std::size_t front = plain.find("class=\"front\"");
  const std::string path =
    plain.substr(plain.rfind("<path", front), front - plain.rfind("<path", front));
  Expect(Count(path, "H") == 3 && Count(path, "V") == 3, "the front is a step function: " + path);
  Expect(Count(plain, "peer (peer)") == 1, "the legend marks the baseline");
  Expect(Count(plain, "class=\"mark\"") == 6 + 3, "one mark per point and per legend entry");
  Expect(Count(plain, ">1e-05<") == 1 && Count(plain, ">10<") == 1, "both axes are logarithmic");
  Expect(Count(plain, ">machine<") == 1 && Count(plain, ">conditions<") == 1,
    "the caption has two lines");

  plot.SetDefault("fine", "8");
  Expect(Count(MakeSvg(plot, ""), "class=\"default\"") == 2, "the default is marked and named");
  Expect(IsWellFormed(MakeSvg(plot, "")), "tags are well formed");
  plot.HasFront = false;
  Expect(Count(MakeSvg(plot, ""), "class=\"front\"") == 0, "the front is drawn only on request");
  plot.Title = "a < b";
  Expect(Count(MakeSvg(plot, ""), ">a &lt; b<") == 1, "text is escaped");
  plot.AddPoint("exact", false, 1.0, 0.0);
  Expect(Count(MakeSvg(plot, ""), "inf") + Count(MakeSvg(plot, ""), "nan") == 0,
    "an error of 0 is not drawn on a logarithmic axis");
}

/// Checks that a point at (1, 1) is at the center of logarithmic axes from 1e-1 to 1e1.
void CheckPositions()
{
  BenchPlot plot = BenchPlot::OfErrors("places", "Places", "x", "y");
  plot.HasFront = false;
  plot.AddPoint("line", false, 0.2, 0.2);
  plot.AddPoint("line", false, 1.0, 1.0);
  plot.AddPoint("line", false, 5.0, 5.0);
  const std::string svg = MakeSvg(plot, "");
  Expect(Count(svg, "translate(480 395)") == 1, "1 is at the center of both axes");
}

double GrayOf(const std::string& color)
{
  const int number = std::stoi(color.substr(1), nullptr, 16);
  return 0.299 * (number >> 16) + 0.587 * (number >> 8 & 255) + 0.114 * (number & 255);
}

/// Checks that series can be told apart without colors: lines by their marks, bars by their gray
/// levels.
void CheckGrays()
{
  std::set<std::string> marks;
  for (std::size_t i = 0; i < NumberOfMarks; ++i)
  {
    marks.insert(MarkOf(i));
  }
  Expect(marks.size() == NumberOfMarks && NumberOfMarks >= 12, "marks differ");
  constexpr std::size_t count = 5;
  for (std::size_t i = 0; i < count; ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      Expect(std::abs(GrayOf(ColorOf(i)) - GrayOf(ColorOf(j))) > 30.0,
        "bars " + std::to_string(j) + " and " + std::to_string(i) + " have different gray levels");
    }
  }
}

void CheckBars()
{
  BenchPlot plot;
  plot.Kind = BenchPlot::BARS;
  plot.BarLabels = { "first", "second" };
  plot.Reference = 1.0;
  plot.AddPoint("1 thread", false, 0.0, 2.0);
  plot.AddPoint("1 thread", false, 1.0, 1.0);
  const std::string svg = MakeSvg(plot, "");
  Expect(IsWellFormed(svg), "tags are well formed");
  Expect(Count(svg, "class=\"bar\"") == 2 + 1, "one bar per case and per legend entry");
  Expect(Count(svg, ">first<") == 1 && Count(svg, ">second<") == 1, "bars have labels");
}

/// Checks that lines are dashed for baselines and for series that are only shown for comparison.
void CheckDashes()
{
  BenchPlot plot = MakePlot();
  plot.ExcludeFromFront("coarse");
  const std::string svg = MakeSvg(plot, "");
  Expect(Count(svg, "class=\"line\"") == 2 &&
      Count(svg, "class=\"line peer\" stroke-dasharray") == 2 &&
      Count(svg, "class=\"line no-choice\" stroke-dasharray") == 2,
    "one line per series and legend entry, dashed for baselines and unselectable series");
}
}

int main()
{
  CheckFront();
  CheckSummaries();
  CheckRows();
  CheckClocks();
  CheckImage();
  CheckPositions();
  CheckGrays();
  CheckBars();
  CheckDashes();
  return Success ? EXIT_SUCCESS : EXIT_FAILURE;
}

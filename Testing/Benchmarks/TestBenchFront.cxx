// SPDX-License-Identifier: BSD-3-Clause
// Fronts, defaults and answers of plots that are made up, and what images show of them.
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

int Count(const std::string& text, const std::string& part)
{
  int number = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
  {
    ++number;
  }
  return number;
}

/// Whether no tag begins within another, and each one ends.
bool IsWellFormed(const std::string& svg)
{
  bool isInside = false;
  for (const char letter : svg)
  {
    if ((letter == '<' && isInside) || (letter == '>' && !isInside))
    {
      return false;
    }
    isInside = letter == '<' || (isInside && letter != '>');
  }
  return !isInside && Count(svg, "<text") == Count(svg, "</text>");
}

void CheckImage()
{
  BenchPlot plot = MakePlot();
  const std::string plain = MakeSvg(plot, "machine\nconditions");
  Expect(Count(plain, "class=\"default\"") == 0, "a ring around nothing");
  // The path of the stairs has the first point and a step to each of the other three.
  const std::size_t front = plain.find("class=\"front\"");
  const std::string path =
    plain.substr(plain.rfind("<path", front), front - plain.rfind("<path", front));
  Expect(Count(path, "H") == 3 && Count(path, "V") == 3, "the front is stairs: " + path);
  Expect(Count(plain, "peer (peer)") == 1, "the peer is called one");
  Expect(Count(plain, "class=\"mark\"") == 6 + 3, "a mark for each point and in the legend");
  Expect(Count(plain, ">1e-05<") == 1 && Count(plain, ">10<") == 1, "both axes are logarithmic");
  Expect(Count(plain, ">machine<") == 1 && Count(plain, ">conditions<") == 1, "the caption");

  plot.SetDefault("fine", "8");
  Expect(Count(MakeSvg(plot, ""), "class=\"default\"") == 2, "the default is ringed and named");
  Expect(IsWellFormed(MakeSvg(plot, "")), "tags are well formed");
  plot.HasFront = false;
  Expect(Count(MakeSvg(plot, ""), "class=\"front\"") == 0, "a front that was not asked for");
  plot.Title = "a < b";
  Expect(Count(MakeSvg(plot, ""), ">a &lt; b<") == 1, "text is escaped");
  plot.AddPoint("exact", false, 1.0, 0.0);
  Expect(Count(MakeSvg(plot, ""), "inf") + Count(MakeSvg(plot, ""), "nan") == 0,
    "an error of 0 has no place on a logarithmic axis");
}

/// Where points are: at the ends and in the middle of logarithmic axes from 1e-1 to 1e1.
void CheckPlaces()
{
  BenchPlot plot = BenchPlot::OfErrors("places", "Places", "x", "y");
  plot.HasFront = false;
  plot.AddPoint("line", false, 0.2, 0.2);
  plot.AddPoint("line", false, 1.0, 1.0);
  plot.AddPoint("line", false, 5.0, 5.0);
  const std::string svg = MakeSvg(plot, "");
  Expect(Count(svg, "translate(480 395)") == 1, "1 is in the middle of both axes");
}

double GreyOf(const std::string& color)
{
  const int number = std::stoi(color.substr(1), nullptr, 16);
  return 0.299 * (number >> 16) + 0.587 * (number >> 8 & 255) + 0.114 * (number & 255);
}

/// Series are told apart without colors: lines by their marks, bars by their greys.
void CheckGreys()
{
  std::set<std::string> marks;
  for (std::size_t i = 0; i < NumberOfMarks; ++i)
  {
    marks.insert(MarkOf(i));
  }
  Expect(marks.size() == NumberOfMarks && NumberOfMarks >= 12, "marks differ");
  constexpr std::size_t most = 5;
  for (std::size_t i = 0; i < most; ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      Expect(std::abs(GreyOf(ColorOf(i)) - GreyOf(ColorOf(j))) > 30.0,
        "bars " + std::to_string(j) + " and " + std::to_string(i) + " have alike greys");
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
  Expect(Count(svg, "class=\"bar\"") == 2 + 1, "a bar for each case and in the legend");
  Expect(Count(svg, ">first<") == 1 && Count(svg, ">second<") == 1, "bars have labels");
}

/// Peers, and what nobody can choose, are told from what is ours by their lines.
void CheckDashes()
{
  BenchPlot plot = MakePlot();
  plot.SetNoChoice("coarse");
  const std::string svg = MakeSvg(plot, "");
  Expect(Count(svg, "class=\"line\"") == 2 &&
      Count(svg, "class=\"line peer\" stroke-dasharray") == 2 &&
      Count(svg, "class=\"line no-choice\" stroke-dasharray") == 2,
    "lines of ours, a peer and what is no choice, each with one in the legend");
}
}

int main()
{
  CheckFront();
  CheckAnswers();
  CheckRows();
  CheckClocks();
  CheckImage();
  CheckPlaces();
  CheckGreys();
  CheckBars();
  CheckDashes();
  return Right ? EXIT_SUCCESS : EXIT_FAILURE;
}

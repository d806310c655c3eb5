// SPDX-License-Identifier: BSD-3-Clause
#ifndef Approximation_h
#define Approximation_h

#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Suites/BenchSuite.h"

#include <functional>
#include <string>
#include <vector>

class vtkRenderWindow;

/**
 * Settings by which something is only approximately right: how wrong against how long it takes.
 */
namespace approximations
{
/// What one plot answers.
struct Question
{
  /// The case of its rows and the name of its plot.
  std::string Name;
  std::string Title;
  std::string Text;
  /// What is measured on what, and what it is compared with, for the caption; numbers of sizes
  /// stand in the rows, see Trials::SetSize.
  std::string Conditions;
  std::string TimeLabel;
  std::string ErrorNorm;
};

/// Who makes a trial: ours, ours as nobody has to ask for, another project's.
enum class Maker
{
  Own,
  Default,
  Peer
};

/// What the times of a plot are of: the clock on the wall, or the processor time of all threads,
/// which what else the machine does is not in.
enum class Clock
{
  Wall,
  Processor
};

/// The clock of what draws into a window: the processor's where OpenGL is software, whose threads
/// are this process's, and the one on the wall where a graphics card draws.
Clock ClockOf(vtkRenderWindow* window);

/**
 * The ways to do one thing, which are timed in turn and then compared with a reference.
 */
class Trials
{
public:
  /// \a setting is written beside the point; empty for nothing. \a measure is called after the
  /// runs and once for each trial, in their order.
  void Add(const std::string& method, const std::string& setting, Maker maker,
    const BenchWork& work, const std::function<double()>& measure);

  /// Adds a number to all rows, such as cells or pixels along an edge, for the caption.
  void SetSize(const std::string& name, double number) { this->Sizes[name] = number; }

  /// Measures, and adds a row for each trial: in its counts `default` or `peer`, 1 where it is
  /// that, the sizes, and by the processor's clock `processor_seconds` beside the seconds.
  void Run(const Question& question, const BenchOptions& options, BenchRows& rows,
    Clock clock = Clock::Wall) const;

private:
  struct Trial
  {
    std::string Method;
    std::string Setting;
    Maker By;
    BenchWork Work;
    std::function<double()> Measure;
  };

  std::vector<Trial> All;
  nlohmann::ordered_json Sizes = nlohmann::ordered_json::object();
};

/// A question and who measures it.
struct Family
{
  Question Asked;
  void (*AddRows)(const Question& question, const BenchOptions& options, BenchRows& rows);
};

/// The plot of a question's rows: a series for each method, the default's point ringed. Where the
/// rows have processor seconds, these are its times, and the axis and caption say so.
BenchPlot MakePlot(const Question& question, const std::vector<BenchRow>& rows);

/// Returns the claim that each default is on its front, by GetCostOverFront.
BenchClaim CheckDefaults(const std::vector<Family>& families, const std::vector<BenchRow>& rows);

/// Returns a part whose cases are questions, each with a plot of errors against run times, and
/// whose target is that each default is on its front.
BenchPart MakeFamilyPart(const std::vector<Family>& families);

/// A number in a setting: 0.5, 64.
std::string NumberText(double number);
}

#endif

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
 * Plots of error against run time for approximate methods, with a point for each value of a
 * setting.
 */
namespace approximations
{
/// A question that one plot answers.
struct Question
{
  /// The case in the rows, and the name of the plot.
  std::string Name;
  std::string Title;
  std::string Text;
  /// Data, method and baseline for the caption, to which the sizes in the rows are added; see
  /// Trials::SetSize.
  std::string Conditions;
  std::string TimeLabel;
  std::string ErrorNorm;
};

/// Origin of a trial: Interlume, Interlume with its default setting, or another project.
enum class Maker
{
  Own,
  Default,
  Baseline
};

/// Clock that measures the times of a plot: wall time, or the CPU time of all threads. Other
/// programs do not affect CPU time.
enum class Clock
{
  Wall,
  Processor
};

/// Returns Processor if OpenGL renders in software, with threads of this process. Returns Wall if a
/// graphics card renders.
Clock SelectClock(vtkRenderWindow* window);

/**
 * Alternative methods for one task. They are timed alternately and then compared with a reference.
 */
class Trials
{
public:
  /// Adds a trial. \a setting labels its point in the plot; it may be empty. \a measure returns the
  /// error and is called once for each trial after all runs, in the order of the trials.
  void Add(const std::string& method, const std::string& setting, Maker maker,
    const BenchWork& work, const std::function<double()>& measure);

  /// Stores a size, such as the number of pixels along an edge, in all rows. The caption shows it.
  void SetSize(const std::string& name, double number) { this->Sizes[name] = number; }

  /// Measures all trials and adds a row for each. The counts of a row are the sizes, `default` = 1
  /// for Maker::Default, `peer` = 1 for Maker::Baseline, and `processor_seconds` for
  /// Clock::Processor.
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

/// A question and the function that measures its rows.
struct Family
{
  Question Query;
  void (*AddRows)(const Question& question, const BenchOptions& options, BenchRows& rows);
};

/// Returns the plot of a question's rows: a series for each method, with a ring around the point of
/// the default setting. If the rows have CPU times, the plot shows them instead of wall times, and
/// its axis and caption state this.
BenchPlot MakePlot(const Question& question, const std::vector<BenchRow>& rows);

/// Returns the claim that the default setting of each family is on the Pareto front of the family's
/// plot, see GetCostOverFront.
BenchClaim CheckDefaults(const std::vector<Family>& families, const std::vector<BenchRow>& rows);

/// Returns a part of a suite with one case per question. The part plots error against run time for
/// each question and checks the claim of CheckDefaults().
BenchPart MakeFamilyPart(const std::vector<Family>& families);

/// Formats the value of a setting, such as 0.5 or 64.
std::string NumberText(double number);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Approximations/Approximation.h"

#include "Benchmarks/Results/ErrorFront.h"

#include "vtkOpenGLRenderWindow.h"
#include "Loader/SoftwareOpenGL.h"

#include <algorithm>
#include <iterator>
#include <sstream>

namespace approximations
{
namespace
{
const char* const IsDefault = "default";
const char* const IsBaseline = "peer";
const char* const ProcessorSeconds = "processor_seconds";

/// Formats those counts that were set by Trials::SetSize().
std::string SizesOf(const BenchRow& row)
{
  std::string text;
  for (const auto& count : row.Counts.items())
  {
    if (count.key() != IsDefault && count.key() != IsBaseline && count.key() != ProcessorSeconds)
    {
      text +=
        (text.empty() ? " " : ", ") + count.key() + " " + NumberText(count.value().get<double>());
    }
  }
  return text.empty() ? text : text + ".";
}
}

Clock SelectClock(vtkRenderWindow* window)
{
  auto* opened = vtkOpenGLRenderWindow::SafeDownCast(window);
  return opened && interlume::SoftwareOpenGL::IsUsed(opened) ? Clock::Processor : Clock::Wall;
}

void Trials::Add(const std::string& method, const std::string& setting, Maker maker,
  const BenchWork& work, const std::function<double()>& measure)
{
  this->All.push_back({ method, setting, maker, work, measure });
}

void Trials::Run(
  const Question& question, const BenchOptions& options, BenchRows& rows, Clock clock) const
{
  std::vector<BenchWork> works;
  std::transform(this->All.begin(), this->All.end(), std::back_inserter(works),
    [](const Trial& trial) { return trial.Work; });
  const std::vector<BenchSeconds> seconds = MeasureAlternately(works, options.GetRepeats());
  for (std::size_t i = 0; i < this->All.size(); ++i)
  {
    const Trial& trial = this->All[i];
    BenchRow row = rows.Make(question.Name, trial.Method);
    if (!trial.Setting.empty())
    {
      row.Parameter = trial.Setting;
    }
    row.Seconds = seconds[i];
    row.SetError(question.ErrorNorm, trial.Measure());
    row.Counts = this->Sizes;
    if (clock == Clock::Processor)
    {
      row.Counts[ProcessorSeconds] = seconds[i].Processor;
    }
    if (trial.By != Maker::Own)
    {
      row.Counts[trial.By == Maker::Baseline ? IsBaseline : IsDefault] = 1;
    }
    rows.Add(row);
  }
}

BenchPlot MakePlot(const Question& question, const std::vector<BenchRow>& rows)
{
  BenchPlot plot = BenchPlot::OfErrors(question.Name, question.Title, question.TimeLabel,
    "error: " + question.ErrorNorm, question.Text, question.Conditions);
  bool hasProcessorTimes = false;
  for (const BenchRow& row : rows)
  {
    // An error of zero cannot be drawn on a logarithmic axis.
    if (row.Case != question.Name || !(*row.Error > 0.0))
    {
      continue;
    }
    if (plot.AllSeries.empty())
    {
      plot.Conditions += SizesOf(row);
    }
    hasProcessorTimes = row.Counts.contains(ProcessorSeconds);
    const double seconds =
      hasProcessorTimes ? row.Counts[ProcessorSeconds].get<double>() : row.Seconds->Value;
    const std::string setting = row.Parameter.is_null() ? std::string() : row.GetParameterText();
    plot.AddPoint(row.Method, row.Counts.contains(IsBaseline), seconds, *row.Error, setting);
    if (row.Counts.contains(IsDefault))
    {
      plot.SetDefault(row.Method, setting);
    }
  }
  if (hasProcessorTimes)
  {
    plot.XLabel = "processor " + question.TimeLabel;
    plot.Conditions += " Times are the processor's, of all threads.";
  }
  return plot;
}

BenchClaim CheckDefaults(const std::vector<Family>& families, const std::vector<BenchRow>& rows)
{
  BenchClaim claim;
  claim.Text = "the default at most 1.1 times the time of what has no larger error";
  for (const Family& family : families)
  {
    if (const auto over = GetCostRelativeToFront(MakePlot(family.Query, rows)))
    {
      claim.Cases.push_back({ family.Query.Name, *over, *over <= FrontTolerance });
    }
  }
  return claim;
}

BenchPart MakeFamilyPart(const std::vector<Family>& families)
{
  return { [families](const BenchOptions& options, BenchRows& rows)
    {
      for (const Family& family : families)
      {
        family.AddRows(family.Query, options, rows);
      }
    },
    [families](const std::vector<BenchRow>& rows)
    {
      std::vector<BenchPlot> plots;
      for (const Family& family : families)
      {
        plots.push_back(MakePlot(family.Query, rows));
      }
      return plots;
    },
    [families](const std::vector<BenchRow>& rows)
    { return std::vector<BenchClaim>{ CheckDefaults(families, rows) }; } };
}

std::string NumberText(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}
}

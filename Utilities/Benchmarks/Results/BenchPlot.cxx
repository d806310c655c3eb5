// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Results/BenchPlot.h"

#include <algorithm>

namespace
{
std::vector<BenchPlot::Series>::iterator Find(
  std::vector<BenchPlot::Series>& all, const std::string& label)
{
  return std::find_if(all.begin(), all.end(),
    [&label](const BenchPlot::Series& series) { return series.Label == label; });
}
}

BenchPlot BenchPlot::OfErrors(const std::string& name, const std::string& title,
  const std::string& timeLabel, const std::string& errorLabel, const std::string& question,
  const std::string& conditions)
{
  BenchPlot plot;
  plot.Name = name;
  plot.Title = title;
  plot.Question = question;
  plot.Conditions = conditions;
  plot.XLabel = timeLabel;
  plot.YLabel = errorLabel;
  plot.LogX = true;
  plot.LogY = true;
  plot.HasFront = true;
  return plot;
}

BenchPlot BenchPlot::MakeBarPlot(
  const std::string& name, const std::string& title, const std::string& label)
{
  BenchPlot plot;
  plot.Kind = BARS;
  plot.Name = name;
  plot.Title = title;
  plot.YLabel = label;
  return plot;
}

void BenchPlot::AddBar(
  const std::string& group, const std::string& label, bool isBaseline, double height)
{
  const auto found = std::find(this->BarLabels.begin(), this->BarLabels.end(), group);
  const auto position = static_cast<double>(found - this->BarLabels.begin());
  if (found == this->BarLabels.end())
  {
    this->BarLabels.push_back(group);
  }
  this->AddPoint(label, isBaseline, position, height);
}

void BenchPlot::AddRow(const BenchRow& row, bool isBaseline, const std::string& label)
{
  if (row.Seconds && row.Error && *row.Error > 0.0)
  {
    this->AddPoint(label.empty() ? row.Method : label, isBaseline, *row.Seconds, *row.Error,
      row.GetParameterText());
  }
}

BenchPlot& FindOrAdd(std::vector<BenchPlot>& plots, const BenchPlot& fresh)
{
  const auto found = std::find_if(plots.begin(), plots.end(),
    [&fresh](const BenchPlot& plot) { return plot.Name == fresh.Name; });
  return found == plots.end() ? plots.emplace_back(fresh) : *found;
}

void BenchPlot::AddPoint(
  const std::string& label, bool isBaseline, double x, double y, const std::string& name)
{
  auto found = Find(this->AllSeries, label);
  if (found == this->AllSeries.end())
  {
    found = this->AllSeries.insert(found, Series{ label, isBaseline, true, {}, {}, {} });
  }
  found->X.push_back(x);
  found->Y.push_back(y);
  found->Names.push_back(name);
}

void BenchPlot::ExcludeFromFront(const std::string& label)
{
  const auto series = Find(this->AllSeries, label);
  if (series != this->AllSeries.end())
  {
    series->IsChoice = false;
  }
}

void BenchPlot::SetDefault(const std::string& label, const std::string& name)
{
  this->DefaultPoint = {};
  const auto series = Find(this->AllSeries, label);
  if (series == this->AllSeries.end())
  {
    return;
  }
  for (std::size_t i = 0; i < series->X.size(); ++i)
  {
    if (name.empty() || series->Names[i] == name)
    {
      this->DefaultPoint = { label, series->IsBaseline, series->IsChoice, { series->X[i] },
        { series->Y[i] }, { series->Names[i] } };
    }
  }
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Results/SpeedPlots.h"

#include <algorithm>

namespace
{
std::vector<std::string> BaselinesOf(const std::string& method, const std::vector<BenchRow>& rows)
{
  std::vector<std::string> baselines;
  for (const BenchRow& row : rows)
  {
    if (row.Method == method &&
      std::find(baselines.begin(), baselines.end(), row.Baseline) == baselines.end())
    {
      baselines.push_back(row.Baseline);
    }
  }
  return baselines;
}
}

std::vector<BenchPlot> MakeRatioPlots(
  const std::string& suite, const std::string& method, const std::vector<BenchRow>& rows)
{
  std::vector<BenchPlot> plots;
  for (const std::string& baseline : BaselinesOf(method, rows))
  {
    BenchPlot plot = BenchPlot::MakeBarPlot(suite + "-ratio-" + baseline,
      method + " against " + baseline, "time of " + baseline + " / time of " + method);
    plot.Reference = 1.0;
    for (const BenchRow& row : rows)
    {
      if (row.Method == method && row.Baseline == baseline && row.GetRatio())
      {
        plot.AddBar(row.Case, row.GetParameterText(), false, *row.GetRatio());
      }
    }
    plots.push_back(plot);
  }
  return plots;
}

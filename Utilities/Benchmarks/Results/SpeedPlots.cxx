// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Results/SpeedPlots.h"

#include <algorithm>

namespace
{
std::vector<std::string> PeersOf(const std::string& method, const std::vector<BenchRow>& rows)
{
  std::vector<std::string> peers;
  for (const BenchRow& row : rows)
  {
    if (row.Method == method && std::find(peers.begin(), peers.end(), row.Peer) == peers.end())
    {
      peers.push_back(row.Peer);
    }
  }
  return peers;
}
}

std::vector<BenchPlot> MakeRatioPlots(
  const std::string& suite, const std::string& method, const std::vector<BenchRow>& rows)
{
  std::vector<BenchPlot> plots;
  for (const std::string& peer : PeersOf(method, rows))
  {
    BenchPlot plot;
    plot.Kind = BenchPlot::BARS;
    plot.Name = suite + "-ratio-" + peer;
    plot.Title = method + " against " + peer;
    plot.YLabel = "time of " + peer + " / time of " + method;
    plot.Reference = 1.0;
    for (const BenchRow& row : rows)
    {
      if (row.Method != method || row.Peer != peer || !row.GetRatio())
      {
        continue;
      }
      if (std::find(plot.BarLabels.begin(), plot.BarLabels.end(), row.Case) == plot.BarLabels.end())
      {
        plot.BarLabels.push_back(row.Case);
      }
      plot.AddPoint(row.GetParameterText(), false, static_cast<double>(plot.BarLabels.size() - 1),
        *row.GetRatio());
    }
    plots.push_back(plot);
  }
  return plots;
}

std::vector<BenchPlot> MakeReExtractionPlots(
  const std::string& suite, const std::vector<BenchRow>& rows)
{
  std::vector<BenchPlot> plots;
  for (const BenchRow& row : rows)
  {
    if (row.Method != "re-extract")
    {
      continue;
    }
    const std::string name = suite + "-re-extract-" + row.Case;
    if (plots.empty() || plots.back().Name != name)
    {
      BenchPlot plot;
      plot.Name = name;
      plot.Title = row.Case + ": a changed interval, with and without the value index, 1 thread";
      plot.XLabel = "share of cells with output";
      plot.YLabel = "run time (s)";
      plot.LogX = true;
      plot.LogY = true;
      plot.DefaultSeries = row.Method;
      plots.push_back(plot);
    }
    const double share = row.Counts.at("share");
    if (share > 0.0)
    {
      plots.back().AddPoint(row.Method, false, share, *row.Seconds);
      plots.back().AddPoint(row.Peer, true, share, *row.PeerSeconds);
    }
  }
  return plots;
}

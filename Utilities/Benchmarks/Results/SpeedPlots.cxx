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
    BenchPlot plot = BenchPlot::OfBars(suite + "-ratio-" + peer, method + " against " + peer,
      "time of " + peer + " / time of " + method);
    plot.Reference = 1.0;
    for (const BenchRow& row : rows)
    {
      if (row.Method == method && row.Peer == peer && row.GetRatio())
      {
        plot.AddBar(row.Case, row.GetParameterText(), false, *row.GetRatio());
      }
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
    BenchPlot fresh = BenchPlot::OfErrors(suite + "-re-extract-" + row.Case,
      row.Case + ": a changed interval, with and without the value index, 1 thread",
      "share of cells with output", "run time (s)");
    fresh.HasFront = false;
    fresh.DefaultSeries = row.Method;
    BenchPlot& plot = FindOrAdd(plots, fresh);
    const double share = row.Counts.at("share");
    if (share > 0.0)
    {
      plot.AddPoint(row.Method, false, share, *row.Seconds);
      plot.AddPoint(row.Peer, true, share, *row.PeerSeconds);
    }
  }
  return plots;
}

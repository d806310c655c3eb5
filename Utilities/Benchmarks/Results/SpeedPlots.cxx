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

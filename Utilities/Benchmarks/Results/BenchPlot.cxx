// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Results/BenchPlot.h"

#include <algorithm>

void BenchPlot::AddPoint(const std::string& label, bool isPeer, double x, double y)
{
  auto found = std::find_if(this->AllSeries.begin(), this->AllSeries.end(),
    [&label](const Series& series) { return series.Label == label; });
  if (found == this->AllSeries.end())
  {
    found = this->AllSeries.insert(found, Series{ label, isPeer, {}, {} });
  }
  found->X.push_back(x);
  found->Y.push_back(y);
}

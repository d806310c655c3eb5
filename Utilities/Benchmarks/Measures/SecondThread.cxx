// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Measures/SecondThread.h"

#include <vector>

void MeasureTwoThreads(const BenchWork& work, const BenchOptions& options, BenchRow& row)
{
  // More runs reduce the influence of other processes, and these runs are short.
  const std::vector<BenchSeconds> seconds =
    MeasureAlternately({ WithThreads(1, work), WithThreads(2, work) }, 3 * options.GetRepeats());
  row.SetTimes(seconds[1], "threads-1", seconds[0]);
}

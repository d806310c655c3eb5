// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/BenchOptions.h"

int BenchOptions::GetRepeats() const
{
  return this->Size == FULL ? 5 : 3;
}

std::string BenchOptions::GetSizeName() const
{
  return this->Pick<std::string>("full", "quick", "tiny");
}

std::vector<int> BenchOptions::GetThreadCounts() const
{
  return this->Threads > 1 ? std::vector<int>{ 1, this->Threads } : std::vector<int>{ 1 };
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Measures/ProcessorClock.h"

#include <ctime>

BenchWork ProcessorClock::Watch(const BenchWork& work)
{
  return [work, seconds = this->Seconds]()
  {
    const double begin = GetSteadySeconds();
    const std::clock_t start = std::clock();
    vtkSmartPointer<vtkObjectBase> result = work();
    const double taken = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    seconds->push_back({ taken, 1, { { { begin, GetSteadySeconds() } } } });
    return result;
  };
}

BenchSeconds ProcessorClock::Take()
{
  const BenchSeconds seconds = MedianOf(*this->Seconds);
  this->Seconds->clear();
  return seconds;
}

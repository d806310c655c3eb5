// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Measures/ProcessorClock.h"

#include <ctime>

BenchWork ProcessorClock::Watch(const BenchWork& work)
{
  return [work, seconds = this->Seconds]()
  {
    const std::clock_t start = std::clock();
    vtkSmartPointer<vtkObjectBase> result = work();
    seconds->push_back(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    return result;
  };
}

BenchSeconds ProcessorClock::Take()
{
  const BenchSeconds seconds = MedianOf(*this->Seconds);
  this->Seconds->clear();
  return seconds;
}

// SPDX-License-Identifier: BSD-3-Clause
#ifndef ProcessorClock_h
#define ProcessorClock_h

#include "Benchmarks/Measures/BenchTiming.h"

#include <memory>
#include <vector>

/**
 * The processor seconds of all threads that works take: what else the machine does is not in them.
 */
class ProcessorClock
{
public:
  /// Returns \a work with each of its runs measured. The clock may end before the work.
  BenchWork Watch(const BenchWork& work);

  /// Returns the median of the runs since the last call.
  BenchSeconds Take();

private:
  std::shared_ptr<std::vector<BenchSeconds>> Seconds =
    std::make_shared<std::vector<BenchSeconds>>();
};

#endif

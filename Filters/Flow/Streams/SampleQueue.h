// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SampleQueue_h
#define interlume_SampleQueue_h

#include "Common/Batches.h"

#include <algorithm>
#include <atomic>
#include <thread>

namespace interlume
{

/**
 * Parallel loop over numbered items, for threads that process several items at a time. Whenever an
 * item is done, the thread starts another one. With a fixed range of items for each thread, as in
 * Batches, a thread would process fewer items at a time near the end of its range.
 */
namespace SampleQueue
{
/// Calls \a work(next) in each thread. next() returns an unprocessed item of [first, all), or -1 if
/// none is left.
template <typename Work>
void RunRange(vtkIdType first, vtkIdType all, Work&& work)
{
  // Number of consecutive items that a thread takes at once. They are usually close to each other
  // in space.
  constexpr vtkIdType part = 8;
  std::atomic<vtkIdType> taken(first);
  // In VTK 9.6 the estimated number of threads remains at the lowest value used so far. Therefore
  // make at least one call per processor. Surplus calls find no items left and return immediately.
  const int streams = std::max(vtkSMPTools::GetEstimatedNumberOfThreads(),
    static_cast<int>(std::thread::hardware_concurrency()));
  vtkSMPTools::For(0, streams, 1,
    [&](vtkIdType, vtkIdType)
    {
      if (taken >= all)
      {
        return;
      }
      vtkIdType item = 0;
      vtkIdType last = 0;
      work(
        [&]() -> vtkIdType
        {
          if (item == last)
          {
            item = std::min(taken.fetch_add(part), all);
            last = std::min(item + part, all);
          }
          return item < last ? item++ : -1;
        });
    });
}

/**
 * Divides [0, number) into batches and calls RunRange for each. For progress and abort see
 * Batches::Run.
 */
template <typename Work>
bool Run(vtkIdType number, vtkAlgorithm* owner, double start, double end, Work&& work)
{
  const vtkIdType batches = std::min(number, Batches::NumberOfBatches);
  for (vtkIdType batch = 0; batch < batches; ++batch)
  {
    owner->UpdateProgress(start + (end - start) * static_cast<double>(batch) / batches);
    if (owner->GetAbortExecute())
    {
      return false;
    }
    RunRange(batch * number / batches, (batch + 1) * number / batches, work);
  }
  return !owner->GetAbortExecute();
}
}

}

#endif

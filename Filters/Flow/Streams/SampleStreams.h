// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SampleStreams_h
#define interlume_SampleStreams_h

#include "Common/Batches.h"

#include <algorithm>
#include <atomic>
#include <thread>

namespace interlume
{

/**
 * Runs threads that work on several numbered items at a time, and go on with the next item whenever
 * one is done: with ranges of items, as Batches hands them out, they would have few at the end of
 * each.
 */
namespace SampleStreams
{
/// Each thread calls \a work(next), where next() returns an item of [first, all) that nobody has
/// had, and -1 after the last.
template <typename Work>
void RunRange(vtkIdType first, vtkIdType all, Work&& work)
{
  // Items in a row are near each other, and are taken by one thread.
  constexpr vtkIdType part = 8;
  std::atomic<vtkIdType> taken(first);
  // The estimate of VTK 9.6 stays at the fewest threads that there have been. A stream beyond those
  // that there are begins when all items are taken.
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
 * Each thread calls \a work(next), where next() returns an item of [0, number) that nobody has had,
 * and -1 after the last for the time being. Progress and abort are those of Batches::Run.
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

// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_Batches_h
#define interlume_Batches_h

#include "vtkAlgorithm.h"
#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>

namespace interlume
{

/**
 * Runs parallel loops in a few batches and reports progress between batches.
 */
namespace Batches
{
constexpr vtkIdType NumberOfBatches = 16;

/**
 * Calls \a work(first, last) in parallel for ranges that together cover [0, number). The progress
 * of \a owner advances from \a start to \a end. Returns false if the execution was aborted. If \a
 * owner is null, progress and abort are ignored. Each batch starts the threads again, so pass fewer
 * batches if the work takes less than a millisecond.
 */
template <typename Work>
bool Run(vtkIdType number, vtkAlgorithm* owner, double start, double end, Work&& work,
  vtkIdType numberOfBatches = NumberOfBatches)
{
  const vtkIdType batches = owner ? std::min(number, numberOfBatches) : 1;
  for (vtkIdType batch = 0; batch < batches; ++batch)
  {
    if (owner)
    {
      owner->UpdateProgress(start + (end - start) * static_cast<double>(batch) / batches);
      if (owner->GetAbortExecute())
      {
        return false;
      }
    }
    vtkSMPTools::For(batch * number / batches, (batch + 1) * number / batches, work);
  }
  return !owner || !owner->GetAbortExecute();
}
}

}

#endif

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
 * Runs threads over numbered items, in a few batches between which progress is told.
 */
namespace Batches
{
constexpr vtkIdType NumberOfBatches = 16;

/**
 * Calls \a work(first, last) for all of [0, number) by threads; the progress of \a owner goes from
 * \a start to \a end. Returns false when its execution was aborted. Without an owner, which is
 * null, there is neither progress nor abort. Work of less than a millisecond has fewer batches than
 * the usual number, as each starts the threads anew.
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

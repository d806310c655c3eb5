#ifndef interlume_BatchedRows_h
#define interlume_BatchedRows_h

#include "vtkAlgorithm.h"
#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>

namespace interlume
{

/**
 * Threads over the rows of an image.
 */
namespace BatchedRows
{
/// How often progress is told and an abort seen.
constexpr vtkIdType NumberOfBatches = 32;

/**
 * Calls \a makeRows(first, last) for all rows, by threads, and tells the progress of \a owner from
 * \a start to \a end. False when its execution was aborted.
 */
template <typename Functor>
bool Run(vtkIdType rows, vtkAlgorithm* owner, const Functor& makeRows, double start = 0.0,
  double end = 1.0)
{
  const vtkIdType batches = std::min(rows, NumberOfBatches);
  for (vtkIdType batch = 0; batch < batches; ++batch)
  {
    owner->UpdateProgress(start + (end - start) * static_cast<double>(batch) / batches);
    if (owner->GetAbortExecute())
    {
      return false;
    }
    vtkSMPTools::For(batch * rows / batches, (batch + 1) * rows / batches, makeRows);
  }
  return true;
}
}

}

#endif

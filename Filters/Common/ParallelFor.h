// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ParallelFor_h
#define interlume_ParallelFor_h

#include "vtkSMPTools.h"
#include "vtkType.h"

namespace interlume
{

///@{
/// Calls \a work(i) in parallel for each i from \a begin to \a end - 1. \a grain is as in
/// vtkSMPTools::For.
template <typename Work>
void ParallelFor(vtkIdType begin, vtkIdType end, vtkIdType grain, const Work& work)
{
  vtkSMPTools::For(begin, end, grain,
    [&work](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        work(i);
      }
    });
}
template <typename Work>
void ParallelFor(vtkIdType begin, vtkIdType end, const Work& work)
{
  ParallelFor(begin, end, 0, work);
}
///@}

}

#endif

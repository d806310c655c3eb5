// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_StageProgress_h
#define interlume_StageProgress_h

#include "vtkAlgorithm.h"

namespace interlume
{

/**
 * @class   StageProgress
 * @brief   a part of an algorithm's progress, told at the ends of stages, where it may be aborted
 *
 * Without an owner nothing is told, and nobody aborts. Only the thread that executes the owner may
 * use it.
 */
class StageProgress
{
public:
  StageProgress() = default;
  /// Makes the progress of \a owner go from \a start to \a end.
  StageProgress(vtkAlgorithm* owner, double start, double end)
    : Owner(owner)
    , Start(start)
    , Length(end - start)
  {
  }

  /// Returns the part of this progress from \a start to \a end, 0 to 1.
  StageProgress GetPart(double start, double end) const
  {
    return { this->Owner, this->Start + start * this->Length, this->Start + end * this->Length };
  }

  /// Tells that this much of the work, 0 to 1, is done. Returns false when the execution was
  /// aborted.
  bool Reach(double done) const
  {
    if (this->Owner && !this->IsAborted())
    {
      this->Owner->UpdateProgress(this->Start + done * this->Length);
    }
    return !this->IsAborted();
  }
  bool IsAborted() const { return this->Owner && this->Owner->GetAbortExecute(); }

private:
  vtkAlgorithm* Owner = nullptr;
  double Start = 0.0;
  double Length = 0.0;
};

}

#endif

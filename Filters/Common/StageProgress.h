// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_StageProgress_h
#define interlume_StageProgress_h

#include "vtkAlgorithm.h"

namespace interlume
{

/**
 * @class   StageProgress
 * @brief   reports the progress of one part of an algorithm's execution
 *
 * Without an owner, progress is not reported and the execution cannot be aborted. Use it only in
 * the thread that executes the owner.
 */
class StageProgress
{
public:
  StageProgress() = default;
  /// Maps progress in [0, 1] to the range [\a start, \a end] of the progress of \a owner.
  StageProgress(vtkAlgorithm* owner, double start, double end)
    : Owner(owner)
    , Start(start)
    , Length(end - start)
  {
  }

  /// Returns the subrange [\a start, \a end], where 0 is the start of this range and 1 its end.
  StageProgress GetPart(double start, double end) const
  {
    return { this->Owner, this->Start + start * this->Length, this->Start + end * this->Length };
  }

  /// Reports that the fraction \a done of the work, 0 to 1, is complete. Returns false if the
  /// execution was aborted.
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

// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ExtractionFrame_h
#define interlume_ExtractionFrame_h

#include "Common/ThreadLocals.h"
#include "Pass/ExtractionContext.h"

#include <array>

namespace interlume
{

/**
 * @class   ExtractionFrame
 * @brief   runs the stages of an extraction: classify, count, allocate, write
 *
 * A pass derives from it, for one kind of grid, which it divides into parts: rows or chunks of
 * cells. Any number of threads count and write parts. The result does not depend on the number of
 * threads, since the counts of the preceding parts determine where a part is written. \a Local is
 * the data of a thread. A pass has these stages:
 * - bool Classify(): computes the codes of the points. Like Settle(), it returns false if the user
 *   aborted.
 * - void CountPart(vtkIdType part, Local&): counts the output of a part.
 * - bool Settle(): does what depends on the counts of all parts.
 * - void Allocate(): turns counts into offsets, and allocates the output.
 * - void WritePart(vtkIdType part, Local&): writes the output of a part.
 * - void Finish(): gathers the results of parts and threads.
 * - Progress: the progress at the beginning and end of counting, then of writing.
 */
template <typename Pass, typename Local>
class ExtractionFrame
{
public:
  /// Runs the stages. Returns false if the user aborted.
  bool Execute(vtkIdType parts)
  {
    Pass& pass = static_cast<Pass&>(*this);
    constexpr std::array<double, 4> at = Pass::Progress;
    if (!pass.Classify() ||
      !this->ForEachPart(parts, at[0], at[1],
        [&pass](vtkIdType part, Local& local) { pass.CountPart(part, local); }) ||
      !pass.Settle())
    {
      return false;
    }
    pass.Allocate();
    const bool isWritten = this->ForEachPart(
      parts, at[2], at[3], [&pass](vtkIdType part, Local& local) { pass.WritePart(part, local); });
    if (isWritten)
    {
      pass.Finish();
    }
    return isWritten;
  }

protected:
  explicit ExtractionFrame(const ExtractionContext& context)
    : Context(context)
    , Values(*context.Values)
  {
  }

  /// Calls work(part, local) for all parts, while progress goes from \a from to \a to. Returns
  /// false if the user aborted.
  template <typename Work>
  bool ForEachPart(vtkIdType parts, double from, double to, Work&& work)
  {
    return this->Context.Run(parts, from, to,
      [this, &work](vtkIdType first, vtkIdType last)
      {
        Local& local = this->Locals.Local();
        for (vtkIdType part = first; part < last; ++part)
        {
          work(part, local);
        }
      });
  }

  const ExtractionContext& Context;
  const ExtractionValues& Values;
  ThreadLocals<Local> Locals;
};

}

#endif

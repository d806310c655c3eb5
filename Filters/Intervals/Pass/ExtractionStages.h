// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ExtractionStages_h
#define interlume_ExtractionStages_h

#include "Common/ThreadLocals.h"
#include "Pass/ExtractionContext.h"

#include <array>

namespace interlume
{

/**
 * @class   ExtractionStages
 * @brief   runs the stages of an extraction: classify, count, allocate, write
 *
 * A pass derives from this class for one kind of grid and divides the grid into parts: rows or
 * chunks of cells. Parts are counted and written in parallel. The counts of the preceding parts
 * determine the output position of a part, so the result does not depend on the number of threads.
 * \a Local is per-thread data. A pass has these stages:
 * - bool Classify(): computes the codes of the points. Like Settle(), it returns false if the user
 *   aborted.
 * - void CountPart(vtkIdType part, Local&): counts the output of a part.
 * - bool Settle(): does the work that depends on the counts of all parts.
 * - void Allocate(): converts counts to offsets and allocates the output.
 * - void WritePart(vtkIdType part, Local&): writes the output of a part.
 * - void Finish(): gathers the results of parts and threads.
 * - Progress: four numbers, the progress at the start and end of counting and at the start and end
 *   of writing.
 */
template <typename Pass, typename Local>
class ExtractionStages
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
  explicit ExtractionStages(const ExtractionContext& context)
    : Context(context)
    , Values(*context.Values)
  {
  }

  /// Calls work(part, local) for all parts while progress advances from \a from to \a to. Returns
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

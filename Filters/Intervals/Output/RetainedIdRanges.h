// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RetainedIdRanges_h
#define interlume_RetainedIdRanges_h

#include "Common/ParallelFor.h"

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>
#include <vector>

namespace interlume
{

/**
 * @class   RetainedIdRanges
 * @brief   ranges [first, last) of points or simplices that are retained when others are removed
 */
class RetainedIdRanges
{
public:
  /// Retains those of \a number items that have a nonzero mark.
  template <typename Mark>
  RetainedIdRanges(const Mark* marks, vtkIdType number)
  {
    const Mark* const end = marks + number;
    const auto isRetained = [](const Mark& mark) { return mark != 0; };
    for (const Mark* at = std::find_if(marks, end, isRetained); at != end;)
    {
      const Mark* const gone = std::find_if_not(at, end, isRetained);
      this->Add(at - marks, gone - marks);
      at = std::find_if(gone, end, isRetained);
    }
  }

  /// Retains all of \a number items except those in \a removed, which must be in ascending order.
  RetainedIdRanges(const std::vector<vtkIdType>& removed, vtkIdType number)
  {
    vtkIdType first = 0;
    for (const vtkIdType gone : removed)
    {
      this->Add(first, gone);
      first = gone + 1;
    }
    this->Add(first, number);
  }

  /// Returns the number of retained items.
  vtkIdType GetNumber() const { return this->Number; }

  /// Moves the retained tuples, of \a size values each, to the front, in parallel for large arrays.
  template <typename T>
  void Compact(T* values, vtkIdType size) const
  {
    constexpr vtkIdType minimumBytes = vtkIdType(1) << 18;
    const vtkIdType bytes = this->Number * size * static_cast<vtkIdType>(sizeof(T));
    const vtkIdType parts =
      std::min<vtkIdType>(vtkSMPTools::GetEstimatedNumberOfThreads(), bytes / minimumBytes);
    this->Compact(values, size, std::max<vtkIdType>(parts, 1));
  }

  /// Moves the retained tuples in parallel, in \a parts parts. First, each part buffers those of
  /// its tuples that other parts may overwrite.
  template <typename T>
  void Compact(T* values, vtkIdType size, vtkIdType parts) const
  {
    std::vector<Part<T>> all(parts);
    ParallelFor(0, parts,
      [&](vtkIdType p)
      {
        Part<T>& part = all[p];
        part.First = this->Number * p / parts;
        part.Last = this->Number * (p + 1) / parts;
        part.BufferBegin = std::clamp(this->CountBefore(part.Last), part.First, part.Last);
        part.Buffer.resize((part.Last - part.BufferBegin) * size);
        this->Copy(values, size, part.BufferBegin, part.Last, part.Buffer.data());
      });
    vtkSMPTools::For(0, parts,
      [&](vtkIdType first, vtkIdType last)
      {
        // The parts must be independent. In forward order, single-threaded tests would not detect a
        // dependency between them.
        for (vtkIdType p = last; p-- > first;)
        {
          const Part<T>& part = all[p];
          this->Copy(values, size, part.First, part.BufferBegin, values + part.First * size);
          std::copy(part.Buffer.begin(), part.Buffer.end(), values + part.BufferBegin * size);
        }
      });
  }

  /// Writes the new ids of the retained items, indexed by old id.
  template <typename Id>
  void FillIds(Id* ids) const
  {
    ParallelFor(0, static_cast<vtkIdType>(this->Runs.size()),
      [&](vtkIdType r)
      {
        const Run& run = this->Runs[r];
        for (vtkIdType i = run.First; i < run.Last; ++i)
        {
          ids[i] = static_cast<Id>(run.NewFirst + i - run.First);
        }
      });
  }

private:
  struct Run
  {
    vtkIdType First;
    vtkIdType Last;
    vtkIdType NewFirst;
  };

  // The destination range [First, Last) of one part. The tuples [BufferBegin, Last) are read from
  // the buffer.
  template <typename T>
  struct Part
  {
    vtkIdType First;
    vtkIdType BufferBegin;
    vtkIdType Last;
    std::vector<T> Buffer;
  };

  void Add(vtkIdType first, vtkIdType last)
  {
    if (first < last)
    {
      this->Runs.push_back({ first, last, this->Number });
      this->Number += last - first;
    }
  }

  // Returns the number of retained items before an index.
  vtkIdType CountBefore(vtkIdType index) const
  {
    const auto after = std::upper_bound(this->Runs.begin(), this->Runs.end(), index,
      [](vtkIdType at, const Run& run) { return at < run.First; });
    if (after == this->Runs.begin())
    {
      return 0;
    }
    const Run& run = *(after - 1);
    return run.NewFirst + std::min(index, run.Last) - run.First;
  }

  // Copies the tuples with the new indices [first, last) to \a out. \a out may be inside \a values
  // if no tuple moves to a higher index.
  template <typename T>
  void Copy(const T* values, vtkIdType size, vtkIdType first, vtkIdType last, T* out) const
  {
    auto run = std::upper_bound(this->Runs.begin(), this->Runs.end(), first,
      [](vtkIdType at, const Run& other) { return at < other.NewFirst; });
    for (run -= first < last; first < last; ++run)
    {
      const vtkIdType from = run->First + first - run->NewFirst;
      const vtkIdType number = std::min(run->Last - from, last - first);
      const T* const tuples = values + from * size;
      // Skip a range that does not move.
      out = out == tuples ? out + number * size : std::copy_n(tuples, number * size, out);
      first += number;
    }
  }

  std::vector<Run> Runs;
  vtkIdType Number = 0;
};

}

#endif

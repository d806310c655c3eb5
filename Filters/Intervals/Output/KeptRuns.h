// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_KeptRuns_h
#define interlume_KeptRuns_h

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>
#include <vector>

namespace interlume
{

/**
 * @class   KeptRuns
 * @brief   the points or simplices [first, last), several times, that stay where others are left
 * out
 */
class KeptRuns
{
public:
  /// Finds the items of \a number whose marks are not 0.
  template <typename Mark>
  KeptRuns(const Mark* marks, vtkIdType number)
  {
    const Mark* const end = marks + number;
    const auto isKept = [](const Mark& mark) { return mark != 0; };
    for (const Mark* at = std::find_if(marks, end, isKept); at != end;)
    {
      const Mark* const gone = std::find_if_not(at, end, isKept);
      this->Add(at - marks, gone - marks);
      at = std::find_if(gone, end, isKept);
    }
  }

  /// Leaves out of \a number items those in \a removed, which increase.
  KeptRuns(const std::vector<vtkIdType>& removed, vtkIdType number)
  {
    vtkIdType first = 0;
    for (const vtkIdType gone : removed)
    {
      this->Add(first, gone);
      first = gone + 1;
    }
    this->Add(first, number);
  }

  /// Returns how many items stay.
  vtkIdType GetNumber() const { return this->Number; }

  /// Moves tuples of \a size values together, those that stay to the front.
  template <typename T>
  void Compact(T* values, vtkIdType size) const
  {
    constexpr vtkIdType leastBytes = vtkIdType(1) << 18;
    const vtkIdType bytes = this->Number * size * static_cast<vtkIdType>(sizeof(T));
    const vtkIdType parts =
      std::min<vtkIdType>(vtkSMPTools::GetEstimatedNumberOfThreads(), bytes / leastBytes);
    this->Compact(values, size, std::max<vtkIdType>(parts, 1));
  }

  /// Does so in \a parts by threads. What a part moves from the places that another part fills is
  /// put aside before.
  template <typename T>
  void Compact(T* values, vtkIdType size, vtkIdType parts) const
  {
    std::vector<Part<T>> all(parts);
    vtkSMPTools::For(0, parts,
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType p = first; p < last; ++p)
        {
          Part<T>& part = all[p];
          part.First = this->Number * p / parts;
          part.Last = this->Number * (p + 1) / parts;
          part.Middle = std::clamp(this->CountBefore(part.Last), part.First, part.Last);
          part.Aside.resize((part.Last - part.Middle) * size);
          this->Copy(values, size, part.Middle, part.Last, part.Aside.data());
        }
      });
    vtkSMPTools::For(0, parts,
      [&](vtkIdType first, vtkIdType last)
      {
        // No part needs one before it: one thread takes the last first, so that a test sees that.
        for (vtkIdType p = last; p-- > first;)
        {
          const Part<T>& part = all[p];
          this->Copy(values, size, part.First, part.Middle, values + part.First * size);
          std::copy(part.Aside.begin(), part.Aside.end(), values + part.Middle * size);
        }
      });
  }

  /// Writes the new ids of the items that stay.
  template <typename Id>
  void FillIds(Id* ids) const
  {
    vtkSMPTools::For(0, static_cast<vtkIdType>(this->Runs.size()),
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType r = first; r < last; ++r)
        {
          const Run& run = this->Runs[r];
          for (vtkIdType i = run.First; i < run.Last; ++i)
          {
            ids[i] = static_cast<Id>(run.NewFirst + i - run.First);
          }
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

  // The new places [First, Last) that one thread fills; from Middle on with what was put aside.
  template <typename T>
  struct Part
  {
    vtkIdType First;
    vtkIdType Middle;
    vtkIdType Last;
    std::vector<T> Aside;
  };

  void Add(vtkIdType first, vtkIdType last)
  {
    if (first < last)
    {
      this->Runs.push_back({ first, last, this->Number });
      this->Number += last - first;
    }
  }

  // Returns how many of the items before a place stay.
  vtkIdType CountBefore(vtkIdType place) const
  {
    const auto after = std::upper_bound(this->Runs.begin(), this->Runs.end(), place,
      [](vtkIdType at, const Run& run) { return at < run.First; });
    if (after == this->Runs.begin())
    {
      return 0;
    }
    const Run& run = *(after - 1);
    return run.NewFirst + std::min(place, run.Last) - run.First;
  }

  // Copies the tuples of the new places [first, last) to \a out, which may be among \a values where
  // no tuple is before its new place.
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
      // What is in its place already stays there.
      out = out == tuples ? out + number * size : std::copy_n(tuples, number * size, out);
      first += number;
    }
  }

  std::vector<Run> Runs;
  vtkIdType Number = 0;
};

}

#endif

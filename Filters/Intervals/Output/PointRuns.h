// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PointRuns_h
#define interlume_PointRuns_h

#include "vtkType.h"

#include <algorithm>
#include <array>
#include <vector>

namespace interlume
{

/**
 * @class   PointRuns
 * @brief   the points [first, last), several times, that stay where others are left out
 */
class PointRuns
{
public:
  /// Finds the points of \a number whose marks are not 0.
  template <typename Mark>
  PointRuns(const Mark* marks, vtkIdType number)
  {
    const Mark* const end = marks + number;
    const auto isKept = [](const Mark& mark) { return mark != 0; };
    for (const Mark* at = std::find_if(marks, end, isKept); at != end;)
    {
      const Mark* const gone = std::find_if_not(at, end, isKept);
      this->Runs.push_back({ { at - marks, gone - marks } });
      this->Number += gone - at;
      at = std::find_if(gone, end, isKept);
    }
  }

  /// Returns how many points stay.
  vtkIdType GetNumber() const { return this->Number; }

  /// Moves tuples of \a size values together, those that stay to the front.
  template <typename T>
  void Compact(T* values, vtkIdType size) const
  {
    T* out = values;
    for (const Run& run : this->Runs)
    {
      T* const first = values + run[0] * size;
      T* const last = values + run[1] * size;
      // What is in its place already stays there.
      out = out == first ? last : std::copy(first, last, out);
    }
  }

  /// Writes the new ids of the points that stay.
  template <typename Id>
  void FillIds(Id* ids) const
  {
    Id next = 0;
    for (const Run& run : this->Runs)
    {
      for (vtkIdType p = run[0]; p < run[1]; ++p)
      {
        ids[p] = next++;
      }
    }
  }

private:
  using Run = std::array<vtkIdType, 2>;

  std::vector<Run> Runs;
  vtkIdType Number = 0;
};

}

#endif

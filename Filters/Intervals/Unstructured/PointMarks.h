// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PointMarks_h
#define interlume_PointMarks_h

#include "Output/ExtractionBuffer.h"
#include "Scalars/ExtractionValues.h"
#include "Scalars/RowKernels.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace interlume
{

/**
 * @class   PointMarks
 * @brief   one byte for each point, of which the union over a cell tells whether it matters
 *
 * The codes are grouped into at most seven ranges, with one bit each; the eighth bit stands for
 * NaN and infinities. The ranges are single codes for up to three isovalues; with more of them a
 * cell may be called near that is not, never the other way round.
 */
class PointMarks
{
public:
  using Code = ExtractionValues::Code;
  using Mark = std::uint8_t;

  PointMarks(const ExtractionValues& values, vtkIdType points)
    : NonFinite(values.GetNonFiniteCode())
  {
    while ((this->NonFinite - 1) >> this->Shift >= NumberOfRanges)
    {
      ++this->Shift;
    }
    for (int all = 1; all < NonFiniteMark; ++all)
    {
      int first = 0;
      int last = 0;
      while (!((all >> first) & 1))
      {
        ++first;
      }
      while (all >> (last + 1))
      {
        ++last;
      }
      const Code least = static_cast<Code>(first << this->Shift);
      const Code greatest = static_cast<Code>(
        std::min(((last + 1) << this->Shift) - 1, static_cast<int>(this->NonFinite) - 1));
      const auto& items = values.GetItems();
      this->Near[all] = std::any_of(items.begin(), items.end(),
        [&](const ExtractionValues::Item& item)
        { return !values.IsOutside(item, least, greatest); });
    }
    for (int code = 0; code < this->NonFinite; ++code)
    {
      this->OfCodes.push_back(static_cast<Mark>(1u << (code >> this->Shift)));
    }
    this->OfCodes.push_back(NonFiniteMark);
    for (int code = 0; code < this->NonFinite; ++code)
    {
      this->Steps.push_back(static_cast<Mark>(this->OfCodes[code + 1] - this->OfCodes[code]));
    }
    this->Marks.Allocate(points);
  }

  void Fill(const Code* codes, vtkIdType first, vtkIdType last)
  {
    const Mark* const ofCodes = this->OfCodes.data();
    Mark* const marks = this->Marks.GetData();
    const int steps = static_cast<int>(this->Steps.size());
    if (steps == 3 || steps == 5)
    {
      RowKernels::FillMarks(codes + first, last - first, this->Steps.data(), steps, marks + first);
      return;
    }
    for (vtkIdType p = first; p < last; ++p)
    {
      marks[p] = ofCodes[codes[p]];
    }
  }

  /// Computes the union of the marks of each point at two time steps.
  void Fill(const Code* codes, const Code* codesAfter, vtkIdType first, vtkIdType last)
  {
    const Mark* const ofCodes = this->OfCodes.data();
    Mark* const marks = this->Marks.GetData();
    for (vtkIdType p = first; p < last; ++p)
    {
      marks[p] = static_cast<Mark>(ofCodes[codes[p]] | ofCodes[codesAfter[p]]);
    }
  }

  const Mark* GetData() const { return this->Marks.GetData(); }
  void Free() { this->Marks.Free(); }
  std::size_t GetBytes() const { return this->Marks.GetBytes(); }

  /// Returns whether the marks are of one value's codes: below, equal or above.
  bool AreOfOneValue() const { return this->NonFinite == 3; }
  ///@{
  /// Of one value: whether a point's mark says that the value is reached, and whether the marks of
  /// all corners, or-ed, say that one is equal to it.
  static bool IsReached(Mark mark) { return mark > 1; }
  static bool HasTie(Mark all) { return all & 2; }
  ///@}

  /// The following functions take the marks of all corners, or-ed.
  static bool IsNonFinite(Mark all) { return all & NonFiniteMark; }
  bool IsNear(Mark all) const { return this->Near[all]; }

private:
  static constexpr int NumberOfRanges = 7;
  static constexpr Mark NonFiniteMark = 1 << NumberOfRanges;

  Code NonFinite;
  int Shift = 0;
  std::array<bool, 256> Near{};
  std::vector<Mark> OfCodes;
  // By how much the mark of each code but the first is greater than that of the one before.
  std::vector<Mark> Steps;
  ExtractionBuffer<Mark> Marks;
};

}

#endif

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
 * @brief   one byte per point; the bitwise OR over a cell's corners shows whether an item may
 *          intersect the cell
 *
 * The codes are grouped into at most seven ranges with one bit each. The eighth bit marks NaN and
 * infinities. With up to three isovalues, each range is a single code. With more isovalues the test
 * is conservative: it may accept a cell that no item intersects, but never rejects one that an item
 * intersects.
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
      const Code minimum = static_cast<Code>(first << this->Shift);
      const Code maximum = static_cast<Code>(
        std::min(((last + 1) << this->Shift) - 1, static_cast<int>(this->NonFinite) - 1));
      const auto& items = values.GetItems();
      this->Near[all] = std::any_of(items.begin(), items.end(),
        [&](const ExtractionValues::Item& item)
        { return !values.IsOutside(item, minimum, maximum); });
    }
    for (int code = 0; code < this->NonFinite; ++code)
    {
      this->CodeMarks.push_back(static_cast<Mark>(1u << (code >> this->Shift)));
    }
    this->CodeMarks.push_back(NonFiniteMark);
    for (int code = 0; code < this->NonFinite; ++code)
    {
      this->Steps.push_back(static_cast<Mark>(this->CodeMarks[code + 1] - this->CodeMarks[code]));
    }
    this->Marks.Allocate(points);
  }

  void Fill(const Code* codes, vtkIdType first, vtkIdType last)
  {
    const Mark* const codeMarks = this->CodeMarks.data();
    Mark* const marks = this->Marks.GetData();
    const int steps = static_cast<int>(this->Steps.size());
    if (steps == 3 || steps == 5)
    {
      RowKernels::FillMarks(codes + first, last - first, this->Steps.data(), steps, marks + first);
      return;
    }
    for (vtkIdType p = first; p < last; ++p)
    {
      marks[p] = codeMarks[codes[p]];
    }
  }

  /// Computes the bitwise OR of each point's marks at two time steps.
  void Fill(const Code* codes, const Code* codesAfter, vtkIdType first, vtkIdType last)
  {
    const Mark* const codeMarks = this->CodeMarks.data();
    Mark* const marks = this->Marks.GetData();
    for (vtkIdType p = first; p < last; ++p)
    {
      marks[p] = static_cast<Mark>(codeMarks[codes[p]] | codeMarks[codesAfter[p]]);
    }
  }

  const Mark* GetData() const { return this->Marks.GetData(); }
  void Free() { this->Marks.Free(); }
  std::size_t GetBytes() const { return this->Marks.GetBytes(); }

  /// Returns true if there is a single isovalue. The marks 1, 2 and 4 then mean below, equal and
  /// above.
  bool HasSingleIsovalue() const { return this->NonFinite == 3; }
  ///@{
  /// For a single isovalue: IsReached() returns true if a point's value is at least the isovalue,
  /// and HasTie() if the value of any corner equals it. \a all is the bitwise OR of the marks of
  /// all corners.
  static bool IsReached(Mark mark) { return mark > 1; }
  static bool HasTie(Mark all) { return all & 2; }
  ///@}

  /// The following functions take the bitwise OR of the marks of a cell's corners.
  static bool IsNonFinite(Mark all) { return all & NonFiniteMark; }
  bool MayIntersect(Mark all) const { return this->Near[all]; }

private:
  static constexpr int NumberOfRanges = 7;
  static constexpr Mark NonFiniteMark = 1 << NumberOfRanges;

  Code NonFinite;
  int Shift = 0;
  std::array<bool, 256> Near{};
  std::vector<Mark> CodeMarks;
  // Difference between the mark of each code and the mark of the previous code, starting with the
  // second code.
  std::vector<Mark> Steps;
  ExtractionBuffer<Mark> Marks;
};

}

#endif

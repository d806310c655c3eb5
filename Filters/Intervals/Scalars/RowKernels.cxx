// SPDX-License-Identifier: BSD-3-Clause
#include "Scalars/RowKernels.h"

#include "Common/SimdDispatch.h"
#include "Scalars/ExtractionKernels.h"

namespace interlume
{

namespace
{
using RowKernels::Code;

// Same as ExtractionValues::CountCrossings, for finite ends.
inline Code CountOnEdge(Code a, Code b)
{
  const Code low = std::min(a, b);
  const Code end = static_cast<Code>(std::max(a, b) >> 1);
  const Code begin = static_cast<Code>((low >> 1) + (low & 1));
  return static_cast<Code>(end - std::min(end, begin));
}

template <int N>
inline void FillMarksOf(const Code* INTERLUME_RESTRICT codes, std::int64_t number,
  const std::uint8_t* steps, std::uint8_t* INTERLUME_RESTRICT marks)
{
  // Use eight-bit arithmetic, and a mask instead of a branch. Otherwise compilers do not vectorize
  // the loop.
  using Byte = std::uint8_t;
  Byte s[N];
  std::copy_n(steps, N, s);
  for (std::int64_t i = 0; i < number; ++i)
  {
    const Byte code = static_cast<Byte>(codes[i]);
    Byte mark = 1;
    for (int k = 0; k < N; ++k)
    {
      const Byte mask = static_cast<Byte>(-static_cast<Byte>(code > k));
      mark = static_cast<Byte>(mark + static_cast<Byte>(s[k] & mask));
    }
    marks[i] = mark;
  }
}

// Combines the digits of the four grid points of each column into one number in base \a Base.
template <int Base>
inline void FillColumns(const Code* INTERLUME_RESTRICT a, const Code* INTERLUME_RESTRICT b,
  const Code* INTERLUME_RESTRICT c, const Code* INTERLUME_RESTRICT d, Code first, Code second,
  std::int64_t number, Code* INTERLUME_RESTRICT columns)
{
  constexpr Code square = Base * Base;
  const auto digit = [first, second](Code code) {
    return static_cast<Code>(static_cast<Code>(code >= first) + static_cast<Code>(code >= second));
  };
  for (std::int64_t i = 0; i < number; ++i)
  {
    columns[i] = static_cast<Code>(digit(a[i]) + static_cast<Code>(square * digit(b[i])) +
      static_cast<Code>(square * square * digit(c[i])) +
      static_cast<Code>(square * square * square * digit(d[i])));
  }
}

// Computes the key of each cell from the numbers of its two columns.
template <int Base>
inline void FillKeysOf(
  const Code* INTERLUME_RESTRICT columns, std::int64_t number, Code* INTERLUME_RESTRICT keys)
{
  for (std::int64_t i = 0; i < number; ++i)
  {
    keys[i] = static_cast<Code>(columns[i] + Base * columns[i + 1]);
  }
}

template <int Base>
inline void FillKeysOf(const Code* const rows[4], Code first, Code second, std::int64_t number,
  Code* columns, Code* keys)
{
  FillColumns<Base>(rows[0], rows[1], rows[2], rows[3], first, second, number + 1, columns);
  FillKeysOf<Base>(columns, number, keys);
}
}

void RowKernels::Classify(
  const float* values, std::int64_t number, const float* thresholds, int count, Code* codes)
{
  SimdDispatch::Call(
    [&]
    {
      count == 2 ? ExtractionKernels::Classify<2>(values, number, thresholds, codes)
                 : ExtractionKernels::Classify<4>(values, number, thresholds, codes);
    });
}

void RowKernels::Classify(
  const double* values, std::int64_t number, const double* thresholds, int count, Code* codes)
{
  SimdDispatch::Call(
    [&]
    {
      count == 2 ? ExtractionKernels::Classify<2>(values, number, thresholds, codes)
                 : ExtractionKernels::Classify<4>(values, number, thresholds, codes);
    });
}

bool RowKernels::AreFinite(const float* values, std::int64_t number)
{
  return SimdDispatch::Call([&] { return ExtractionKernels::AreFinite(values, number); });
}

bool RowKernels::AreFinite(const double* values, std::int64_t number)
{
  return SimdDispatch::Call([&] { return ExtractionKernels::AreFinite(values, number); });
}

void RowKernels::FillMarks(
  const Code* codes, std::int64_t number, const std::uint8_t* steps, int count, std::uint8_t* marks)
{
  SimdDispatch::Call(
    [&]
    {
      count == 3 ? FillMarksOf<3>(codes, number, steps, marks)
                 : FillMarksOf<5>(codes, number, steps, marks);
    });
}

void RowKernels::Summarize(
  const Code* codes, std::int64_t number, Code& minimum, Code& maximum, Code& bits)
{
  SimdDispatch::Call(
    [](const Code* codes, std::int64_t number, Code& minimum, Code& maximum, Code& bits)
    {
      Code low = codes[0];
      Code high = codes[0];
      Code all = 0;
      for (std::int64_t i = 0; i < number; ++i)
      {
        low = std::min(low, codes[i]);
        high = std::max(high, codes[i]);
        all = static_cast<Code>(all | codes[i]);
      }
      minimum = low;
      maximum = high;
      bits = all;
    },
    codes, number, minimum, maximum, bits);
}

void RowKernels::CountOwnedPoints(const Code* here, const Code* along, const Code* above,
  std::int64_t number, const Code* first, Code* second, Code* third, Code* all)
{
  SimdDispatch::Call(
    [](const Code* INTERLUME_RESTRICT here, const Code* INTERLUME_RESTRICT along,
      const Code* INTERLUME_RESTRICT above, std::int64_t number,
      const Code* INTERLUME_RESTRICT first, Code* INTERLUME_RESTRICT second,
      Code* INTERLUME_RESTRICT third, Code* INTERLUME_RESTRICT all)
    {
      for (std::int64_t i = 0; i + 1 < number; ++i)
      {
        second[i] = static_cast<Code>(first[i] + CountOnEdge(here[i], here[i + 1]));
      }
      second[number - 1] = first[number - 1];
      for (std::int64_t i = 0; i < number; ++i)
      {
        third[i] = static_cast<Code>(second[i] + CountOnEdge(here[i], along[i]));
        all[i] = static_cast<Code>(third[i] + CountOnEdge(here[i], above[i]));
      }
    },
    here, along, above, number, first, second, third, all);
}

std::int64_t RowKernels::CountCrossings(
  const Code* here, const Code* along, const Code* above, std::int64_t number)
{
  return SimdDispatch::Call(
    [](const Code* INTERLUME_RESTRICT here, const Code* INTERLUME_RESTRICT along,
      const Code* INTERLUME_RESTRICT above, std::int64_t number)
    {
      std::uint32_t crossings = 0;
      for (std::int64_t i = 0; i < number; ++i)
      {
        crossings += CountOnEdge(here[i], along[i]);
        crossings += CountOnEdge(here[i], above[i]);
      }
      for (std::int64_t i = 0; i + 1 < number; ++i)
      {
        crossings += CountOnEdge(here[i], here[i + 1]);
      }
      return crossings;
    },
    here, along, above, number);
}

void RowKernels::FillKeys(int base, const Code* const rows[4], Code first, Code second,
  std::int64_t number, Code* columns, Code* keys)
{
  SimdDispatch::Call(
    [&]
    {
      base == 3 ? FillKeysOf<3>(rows, first, second, number, columns, keys)
                : FillKeysOf<2>(rows, first, second, number, columns, keys);
    });
}

void RowKernels::FindRanges(
  const Code* const rows[8], std::int64_t number, Code* minimum, Code* maximum, Code* all)
{
  SimdDispatch::Call(
    [](const Code* const rows[8], std::int64_t number, Code* INTERLUME_RESTRICT minimum,
      Code* INTERLUME_RESTRICT maximum, Code* INTERLUME_RESTRICT all)
    {
      const Code* INTERLUME_RESTRICT r[8];
      std::copy_n(rows, 8, r);
      for (std::int64_t i = 0; i <= number; ++i)
      {
        const Code low = std::min(std::min(std::min(r[0][i], r[1][i]), std::min(r[2][i], r[3][i])),
          std::min(std::min(r[4][i], r[5][i]), std::min(r[6][i], r[7][i])));
        const Code high = std::max(std::max(std::max(r[0][i], r[1][i]), std::max(r[2][i], r[3][i])),
          std::max(std::max(r[4][i], r[5][i]), std::max(r[6][i], r[7][i])));
        minimum[i] = low;
        maximum[i] = high;
      }
      for (std::int64_t i = 0; i < number; ++i)
      {
        const Code low = std::min(minimum[i], minimum[i + 1]);
        const Code high = std::max(maximum[i], maximum[i + 1]);
        minimum[i] = low;
        maximum[i] = high;
        all[i] = low == high ? low : ExtractionKernels::Mixed;
      }
    },
    rows, number, minimum, maximum, all);
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Scalars/RowKernels.h"

#include "Common/FunctionClones.h"
#include "Scalars/ExtractionKernels.h"

namespace interlume
{

namespace
{
using RowKernels::Code;

// Does what ExtractionValues::CountCrossings does, for finite ends.
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
  // In eight bits throughout, and a mask in the place of a choice: else no vector code is made.
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

// Computes the digits of a column of four grid points in base \a Base, as one number.
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

// Computes the keys of cells from the columns on their two sides.
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

INTERLUME_FUNCTION_CLONES("avx2")
void RowKernels::Classify(
  const float* values, std::int64_t number, const float* thresholds, int count, Code* codes)
{
  count == 2 ? ExtractionKernels::Classify<2>(values, number, thresholds, codes)
             : ExtractionKernels::Classify<4>(values, number, thresholds, codes);
}

INTERLUME_FUNCTION_CLONES("avx2")
void RowKernels::Classify(
  const double* values, std::int64_t number, const double* thresholds, int count, Code* codes)
{
  count == 2 ? ExtractionKernels::Classify<2>(values, number, thresholds, codes)
             : ExtractionKernels::Classify<4>(values, number, thresholds, codes);
}

INTERLUME_FUNCTION_CLONES("avx2")
bool RowKernels::AreFinite(const float* values, std::int64_t number)
{
  return ExtractionKernels::AreFinite(values, number);
}

INTERLUME_FUNCTION_CLONES("avx2")
bool RowKernels::AreFinite(const double* values, std::int64_t number)
{
  return ExtractionKernels::AreFinite(values, number);
}

INTERLUME_FUNCTION_CLONES("avx2")
void RowKernels::FillMarks(
  const Code* codes, std::int64_t number, const std::uint8_t* steps, int count, std::uint8_t* marks)
{
  count == 3 ? FillMarksOf<3>(codes, number, steps, marks)
             : FillMarksOf<5>(codes, number, steps, marks);
}

INTERLUME_FUNCTION_CLONES("avx2")
void RowKernels::Summarize(
  const Code* codes, std::int64_t number, Code& least, Code& greatest, Code& bits)
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
  least = low;
  greatest = high;
  bits = all;
}

INTERLUME_FUNCTION_CLONES("avx2")
void RowKernels::CountOwned(const Code* INTERLUME_RESTRICT here,
  const Code* INTERLUME_RESTRICT along, const Code* INTERLUME_RESTRICT above, std::int64_t number,
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
}

INTERLUME_FUNCTION_CLONES("avx2")
std::int64_t RowKernels::CountCrossings(const Code* INTERLUME_RESTRICT here,
  const Code* INTERLUME_RESTRICT along, const Code* INTERLUME_RESTRICT above, std::int64_t number)
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
}

INTERLUME_FUNCTION_CLONES("avx2")
void RowKernels::FillKeys(int base, const Code* const rows[4], Code first, Code second,
  std::int64_t number, Code* columns, Code* keys)
{
  base == 3 ? FillKeysOf<3>(rows, first, second, number, columns, keys)
            : FillKeysOf<2>(rows, first, second, number, columns, keys);
}

INTERLUME_FUNCTION_CLONES("avx2")
void RowKernels::FindRanges(const Code* const rows[8], std::int64_t number,
  Code* INTERLUME_RESTRICT least, Code* INTERLUME_RESTRICT greatest, Code* INTERLUME_RESTRICT all)
{
  const Code* INTERLUME_RESTRICT r[8];
  std::copy_n(rows, 8, r);
  for (std::int64_t i = 0; i <= number; ++i)
  {
    const Code low = std::min(std::min(std::min(r[0][i], r[1][i]), std::min(r[2][i], r[3][i])),
      std::min(std::min(r[4][i], r[5][i]), std::min(r[6][i], r[7][i])));
    const Code high = std::max(std::max(std::max(r[0][i], r[1][i]), std::max(r[2][i], r[3][i])),
      std::max(std::max(r[4][i], r[5][i]), std::max(r[6][i], r[7][i])));
    least[i] = low;
    greatest[i] = high;
  }
  for (std::int64_t i = 0; i < number; ++i)
  {
    const Code low = std::min(least[i], least[i + 1]);
    const Code high = std::max(greatest[i], greatest[i + 1]);
    least[i] = low;
    greatest[i] = high;
    all[i] = low == high ? low : ExtractionKernels::Mixed;
  }
}

}

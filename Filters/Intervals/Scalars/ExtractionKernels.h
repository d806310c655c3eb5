// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ExtractionKernels_h
#define interlume_ExtractionKernels_h

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#if defined(_MSC_VER)
#define INTERLUME_RESTRICT __restrict
#else
#define INTERLUME_RESTRICT __restrict__
#endif

namespace interlume
{

/**
 * The inner loops over rows, written so that compilers make vector code of them: no aliasing,
 * 16-bit arithmetic throughout, no branches.
 */
namespace ExtractionKernels
{
using Code = std::uint16_t;

/// Computes the number of thresholds that each value reaches.
template <int N, typename T>
void Classify(const T* INTERLUME_RESTRICT values, std::int64_t number, const T* thresholds,
  Code* INTERLUME_RESTRICT codes)
{
  T t[N];
  std::copy_n(thresholds, N, t);
  for (std::int64_t i = 0; i < number; ++i)
  {
    Code code = 0;
    for (int k = 0; k < N; ++k)
    {
      code = static_cast<Code>(code + static_cast<Code>(values[i] >= t[k]));
    }
    codes[i] = code;
  }
}

/// Computes a mark for each code, of less than 256: 1, and for each k < N that is less than the
/// code steps[k] more.
template <int N>
void FillMarks(const Code* INTERLUME_RESTRICT codes, std::int64_t number, const std::uint8_t* steps,
  std::uint8_t* INTERLUME_RESTRICT marks)
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

/// Returns whether no value is NaN or infinite.
template <typename T>
bool AreFinite(const T* values, std::int64_t number)
{
  int nonFinite = 0;
  for (std::int64_t i = 0; i < number; ++i)
  {
    nonFinite |= !(std::abs(values[i]) <= std::numeric_limits<T>::max());
  }
  return nonFinite == 0;
}

/// Returns the first place after \a first whose code is another than there, or \a last.
inline std::int64_t FindChange(const Code* codes, std::int64_t first, std::int64_t last)
{
  // Codes are compared four at a time.
  constexpr std::int64_t step = sizeof(std::uint64_t) / sizeof(Code);
  constexpr std::uint64_t ones = 0x0001000100010001;
  const Code code = codes[first];
  std::uint64_t four = code * ones;
  while (first + step <= last && four == code * ones)
  {
    std::memcpy(&four, codes + first, sizeof(four));
    first += four == code * ones ? step : 0;
  }
  while (first < last && codes[first] == code)
  {
    ++first;
  }
  return first;
}

/// Returns the first of the places [first, last) where a code in one of four rows is odd, or \a
/// last.
inline std::int64_t FindOdd(const Code* const rows[4], std::int64_t first, std::int64_t last)
{
  // Codes are looked at four at a time.
  constexpr std::int64_t step = sizeof(std::uint64_t) / sizeof(Code);
  constexpr std::uint64_t ones = 0x0001000100010001;
  for (; first + step <= last; first += step)
  {
    std::uint64_t all = 0;
    for (int r = 0; r < 4; ++r)
    {
      std::uint64_t four;
      std::memcpy(&four, rows[r] + first, sizeof(four));
      all |= four;
    }
    if (all & ones)
    {
      break;
    }
  }
  while (first < last && !((rows[0][first] | rows[1][first] | rows[2][first] | rows[3][first]) & 1))
  {
    ++first;
  }
  return first;
}

/**
 * Finds the ends of a row: \a first is the first place whose code is not that at 0, \a last the
 * last whose code is not that at \a number - 1. Where all codes are equal, they are number and -1.
 */
inline void FindEnds(
  const Code* codes, std::int64_t number, std::int64_t& first, std::int64_t& last)
{
  // Codes are compared four at a time.
  constexpr std::int64_t step = sizeof(std::uint64_t) / sizeof(Code);
  constexpr std::uint64_t ones = 0x0001000100010001;
  const auto equals = [codes](std::int64_t at, std::uint64_t pattern)
  {
    std::uint64_t four;
    std::memcpy(&four, codes + at, sizeof(four));
    return four == pattern;
  };
  first = FindChange(codes, 0, number);
  last = first < number ? number - 1 : -1;
  while (last + 1 >= step && equals(last + 1 - step, codes[number - 1] * ones))
  {
    last -= step;
  }
  while (last >= 0 && codes[last] == codes[number - 1])
  {
    --last;
  }
}

/// Finds the least and the greatest code, and all codes or-ed.
inline void Summarize(const Code* INTERLUME_RESTRICT codes, std::int64_t number, Code& least,
  Code& greatest, Code& bits)
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

/// Does what ExtractionValues::CountCrossings does, for finite ends.
inline Code CountCrossings(Code a, Code b)
{
  const Code low = std::min(a, b);
  const Code end = static_cast<Code>(std::max(a, b) >> 1);
  const Code begin = static_cast<Code>((low >> 1) + (low & 1));
  return static_cast<Code>(end - std::min(end, begin));
}

/**
 * Counts what each grid point of a row owns: \a first points of its own, in all \a second with the
 * crossings along i, \a third with those along j, \a all with those along k. On entry \a first is
 * filled.
 */
inline void CountOwned(const Code* INTERLUME_RESTRICT here, const Code* INTERLUME_RESTRICT along,
  const Code* INTERLUME_RESTRICT above, std::int64_t number, const Code* INTERLUME_RESTRICT first,
  Code* INTERLUME_RESTRICT second, Code* INTERLUME_RESTRICT third, Code* INTERLUME_RESTRICT all)
{
  for (std::int64_t i = 0; i + 1 < number; ++i)
  {
    second[i] = static_cast<Code>(first[i] + CountCrossings(here[i], here[i + 1]));
  }
  second[number - 1] = first[number - 1];
  for (std::int64_t i = 0; i < number; ++i)
  {
    third[i] = static_cast<Code>(second[i] + CountCrossings(here[i], along[i]));
    all[i] = static_cast<Code>(third[i] + CountCrossings(here[i], above[i]));
  }
}

/// Sums counts: \a starts has the sum of those before each.
inline void FillStarts(const Code* INTERLUME_RESTRICT counts, std::int64_t number,
  std::uint32_t* INTERLUME_RESTRICT starts)
{
  std::uint32_t total = 0;
  std::int64_t i = 0;
  // Four at a time, so that only one sum of four depends on the one before.
  for (; i + 4 <= number; i += 4)
  {
    const std::uint32_t one = counts[i];
    const std::uint32_t two = one + counts[i + 1];
    const std::uint32_t three = two + counts[i + 2];
    const std::uint32_t four = three + counts[i + 3];
    starts[i] = total;
    starts[i + 1] = total + one;
    starts[i + 2] = total + two;
    starts[i + 3] = total + three;
    total += four;
  }
  for (; i < number; ++i)
  {
    starts[i] = total;
    total += counts[i];
  }
}

/// Counts the crossings along i, j and k of all grid points of a row.
inline std::int64_t CountCrossings(const Code* INTERLUME_RESTRICT here,
  const Code* INTERLUME_RESTRICT along, const Code* INTERLUME_RESTRICT above, std::int64_t number)
{
  std::uint32_t crossings = 0;
  for (std::int64_t i = 0; i < number; ++i)
  {
    crossings += CountCrossings(here[i], along[i]);
    crossings += CountCrossings(here[i], above[i]);
  }
  for (std::int64_t i = 0; i + 1 < number; ++i)
  {
    crossings += CountCrossings(here[i], here[i + 1]);
  }
  return crossings;
}

/// Computes the digits of a column of four grid points in base \a Base, as one number.
template <int Base>
void FillColumns(const Code* INTERLUME_RESTRICT a, const Code* INTERLUME_RESTRICT b,
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

/// Computes the keys of cells from the columns on their two sides.
template <int Base>
void FillKeys(
  const Code* INTERLUME_RESTRICT columns, std::int64_t number, Code* INTERLUME_RESTRICT keys)
{
  for (std::int64_t i = 0; i < number; ++i)
  {
    keys[i] = static_cast<Code>(columns[i] + Base * columns[i + 1]);
  }
}

/// The code of a cell whose corners differ.
constexpr Code Mixed = 65535;

/**
 * Finds of each of \a number cells in a row the least and the greatest code of its corners, and the
 * code that all of them have or Mixed. The eight rows are those around the cells at two times; \a
 * least and \a greatest have room for one more number than there are cells.
 */
inline void FindRanges(const Code* const rows[8], std::int64_t number,
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
    all[i] = low == high ? low : Mixed;
  }
}
}

}

#endif

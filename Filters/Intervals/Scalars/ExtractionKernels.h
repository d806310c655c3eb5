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
 * Inner loops over rows, written for automatic vectorization: no aliasing, 16-bit arithmetic
 * throughout, no branches.
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

/// Returns true if all values are finite.
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

/// Returns the first index after \a first whose code differs from the code at \a first, or \a last.
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

/// Returns the first index in [first, last) with an odd code in any of four rows, or \a last.
inline std::int64_t FindOddCode(const Code* const rows[4], std::int64_t first, std::int64_t last)
{
  // Codes are tested four at a time.
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
 * Finds the range of a row in which codes vary. \a first is the first index whose code differs from
 * the first code, and \a last is the last index whose code differs from the last code. If all codes
 * are equal, \a first is \a number and \a last is -1.
 */
inline void FindVaryingRange(
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

/// Computes the exclusive prefix sums of \a counts.
inline void FillStarts(const Code* INTERLUME_RESTRICT counts, std::int64_t number,
  std::uint32_t* INTERLUME_RESTRICT starts)
{
  std::uint32_t total = 0;
  std::int64_t i = 0;
  // Counts are added in groups of four, so that only one of four sums depends on the previous
  // group.
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

/// Used in place of the code of a cell whose corners have different codes.
constexpr Code Mixed = 65535;
}

}

#endif

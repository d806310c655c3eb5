// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_IdRun_h
#define interlume_IdRun_h

#include "vtkType.h"

#include <cstdint>

#if defined(__SSE2__) || defined(_M_X64)
#include <emmintrin.h>
#define INTERLUME_HAS_STREAMS
#endif

namespace interlume
{

/**
 * @class   IdRun
 * @brief   the ids of cells along a row, each of which has those of the cell before plus one
 */
class IdRun
{
public:
  /// Writes \a number ids for each of \a cells cells, from those of the cell before \a out.
  template <typename Id>
  static void Write(Id* out, int number, vtkIdType cells)
  {
    for (vtkIdType cell = 0; cell < cells; ++cell, out += number)
    {
      const Id* const before = out - number;
      for (int i = 0; i < number; ++i)
      {
        out[i] = before[i] + 1;
      }
    }
  }

  /// Writes \a step times i for i of [first, last) at these places of \a out; past the cache, where
  /// \a isStreamed and Stream() may be used.
  template <typename Id>
  static void FillMultiples(Id* out, Id step, vtkIdType first, vtkIdType last, bool isStreamed)
  {
#if defined(INTERLUME_HAS_STREAMS)
    if (sizeof(Id) == sizeof(vtkTypeInt32) && isStreamed)
    {
      while (first < last && !IsAligned(out + first))
      {
        out[first] = static_cast<Id>(first) * step;
        ++first;
      }
      const int one = static_cast<int>(step);
      const int next = static_cast<int>(first) * one;
      __m128i four = _mm_setr_epi32(next, next + one, next + 2 * one, next + 3 * one);
      const __m128i fourSteps = _mm_set1_epi32(4 * one);
      for (; first + 4 <= last; first += 4)
      {
        _mm_stream_si128(reinterpret_cast<__m128i*>(out + first), four);
        four = _mm_add_epi32(four, fourSteps);
      }
      _mm_sfence();
    }
#else
    static_cast<void>(isStreamed);
#endif
    for (; first < last; ++first)
    {
      out[first] = static_cast<Id>(first) * step;
    }
  }

  /// Returns whether Stream() may and should write a list of \a number tetrahedra: one too long to
  /// be found in a cache afterwards, so that to read its lines before they are written is in vain.
  static bool IsStreamed(const vtkTypeInt32* ids, vtkIdType number)
  {
#if defined(INTERLUME_HAS_STREAMS)
    constexpr vtkIdType least = vtkIdType(1) << 21;
    return number >= least && IsAligned(ids);
#else
    static_cast<void>(ids);
    static_cast<void>(number);
    return false;
#endif
  }

  /// Does what Write() does, for tetrahedra, past the cache.
  static void Stream(vtkTypeInt32* out, int number, vtkIdType cells)
  {
#if defined(INTERLUME_HAS_STREAMS)
    constexpr int most = 16;
    const int tetrahedra = number / 4;
    if (tetrahedra <= most)
    {
      const __m128i one = _mm_set1_epi32(1);
      __m128i* to = reinterpret_cast<__m128i*>(out);
      __m128i ids[most];
      for (int t = 0; t < tetrahedra; ++t)
      {
        ids[t] = _mm_load_si128(to - tetrahedra + t);
      }
      for (vtkIdType cell = 0; cell < cells; ++cell)
      {
        for (int t = 0; t < tetrahedra; ++t)
        {
          ids[t] = _mm_add_epi32(ids[t], one);
          _mm_stream_si128(to++, ids[t]);
        }
      }
      // Other threads see what they are told of.
      _mm_sfence();
      return;
    }
#endif
    Write(out, number, cells);
  }

private:
#if defined(INTERLUME_HAS_STREAMS)
  static bool IsAligned(const void* memory)
  {
    return reinterpret_cast<std::uintptr_t>(memory) % sizeof(__m128i) == 0;
  }
#endif
};

}

#endif

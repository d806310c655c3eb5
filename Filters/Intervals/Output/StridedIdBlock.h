// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_StridedIdBlock_h
#define interlume_StridedIdBlock_h

#include "vtkType.h"

#include <cstdint>

#if defined(__SSE2__) || defined(_M_X64)
#include <emmintrin.h>
#define INTERLUME_HAS_STREAMS
#endif

namespace interlume
{

/**
 * @class   StridedIdBlock
 * @brief   writes point ids of cells along a row, where each cell has the ids of the previous cell
 *          plus 1
 */
class StridedIdBlock
{
public:
  /// Writes \a number ids for each of \a cells cells, continuing from the cell whose ids are stored
  /// just before \a out.
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

  /// Writes out[i] = step * i for i in [first, last). Bypasses the cache if \a isStreamed is true
  /// and the platform supports it.
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

  /// Returns true if Stream() can and should write a list of \a number tetrahedra. A long list does
  /// not fit in the cache, so loading its cache lines before writing them would be wasted.
  static bool ShouldStream(const vtkTypeInt32* ids, vtkIdType number)
  {
#if defined(INTERLUME_HAS_STREAMS)
    constexpr vtkIdType minimum = vtkIdType(1) << 21;
    return number >= minimum && IsAligned(ids);
#else
    static_cast<void>(ids);
    static_cast<void>(number);
    return false;
#endif
  }

  /// Same as Write(), but for tetrahedra only, and bypassing the cache if possible.
  static void Stream(vtkTypeInt32* out, int number, vtkIdType cells)
  {
#if defined(INTERLUME_HAS_STREAMS)
    constexpr int maximum = 16;
    const int tetrahedra = number / 4;
    if (tetrahedra <= maximum)
    {
      const __m128i one = _mm_set1_epi32(1);
      __m128i* to = reinterpret_cast<__m128i*>(out);
      __m128i ids[maximum];
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
      // Make the streamed values visible to other threads.
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

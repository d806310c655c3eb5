// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SortedSimplices_h
#define interlume_SortedSimplices_h

#include <cstdint>

namespace interlume
{

/**
 * @class   SortedSimplices
 * @brief   batch of 4-simplices whose vertices are sorted with SIMD instructions
 *
 * Each 4-simplex has vertices below and above the slice value, but none at it. A vertex is stored
 * as twice its id, plus 1 if it is above the value. \a Key must be unsigned 32-bit for ids that fit
 * in 31 bits, and signed 64-bit otherwise.
 */
template <typename Key>
struct SortedSimplices
{
  static constexpr int Size = 64;
  static constexpr int NumberOfVertices = 5;

  int Number = 0;
  /// The vertices, in ascending order after sorting.
  Key Vertices[NumberOfVertices][Size];
  /// Bit mask of the sorted vertices that are above the value.
  Key Above[Size];
  /// 1 if sorting the vertices took an odd number of swaps, otherwise 0.
  Key IsOdd[Size];
  /// 0 if all vertices are distinct, otherwise 1.
  Key HasEqual[Size];

  /// Adds a 4-simplex. The batch must not be full.
  template <typename Id>
  void Add(const Id* ids, const bool* areAbove)
  {
    for (int v = 0; v < NumberOfVertices; ++v)
    {
      this->Vertices[v][this->Number] =
        static_cast<Key>(ids[v]) * 2 + static_cast<Key>(areAbove[v] ? 1 : 0);
    }
    ++this->Number;
  }

  Key GetId(int vertex, int simplex) const { return this->Vertices[vertex][simplex] >> 1; }
};

/// Sorts the vertices of each simplex in a batch, with the widest SIMD instructions available.
namespace SimplexSorting
{
void Sort(SortedSimplices<std::uint32_t>& simplices);
void Sort(SortedSimplices<std::int64_t>& simplices);
}

}

#endif

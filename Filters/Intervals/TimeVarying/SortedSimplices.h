// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SortedSimplices_h
#define interlume_SortedSimplices_h

#include <cstdint>

namespace interlume
{

/**
 * @class   SortedSimplices
 * @brief   4-simplices that a value crosses, none of their vertices at it, sorted many at a time
 *
 * A vertex is a number: twice its id, and one more where it is above the value. \a Key is an
 * unsigned number of 32 bits for ids that fit 31, or a signed one of 64 bits.
 */
template <typename Key>
struct SortedSimplices
{
  static constexpr int Size = 64;
  static constexpr int NumberOfVertices = 5;

  int Number = 0;
  /// The vertices, in ascending order once they are sorted.
  Key Vertices[NumberOfVertices][Size];
  /// Which of the sorted vertices are above the value, as bits.
  Key Above[Size];
  /// 1 where it took an odd number of exchanges to sort the vertices, else 0.
  Key IsOdd[Size];
  /// 0 where all vertices differ.
  Key HasEqual[Size];

  /// Adds a 4-simplex; there are fewer than Size.
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

/// Sorts the vertices of all simplices, for wider vectors where the machine has them.
namespace SimplexSorting
{
void Sort(SortedSimplices<std::uint32_t>& simplices);
void Sort(SortedSimplices<std::int64_t>& simplices);
}

}

#endif

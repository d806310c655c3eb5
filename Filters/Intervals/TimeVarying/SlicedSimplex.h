// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SlicedSimplex_h
#define interlume_SlicedSimplex_h

#include "Grid/CornerOrder.h"
#include "Output/CrossingKey.h"
#include "Scalars/ExtractionValues.h"

#include "vtkIsotable.h"

#include <algorithm>
#include <array>
#include <utility>

namespace interlume
{

/// Intersection of a 4-simplex with the slice value.
enum class SliceIntersection
{
  None,
  Crosses,
  /// One vertex is below and four are at the value.
  Ends,
  /// Four vertices are at the value and one is above.
  Begins,
  /// All vertices are at the value. The cell is a tetrahedron with its last point repeated.
  InSlice
};

/// A point of a slice: its owner, and its key in the owner's list.
struct SlicePoint
{
  vtkIdType Owner;
  CrossingKey Key;

  bool operator==(const SlicePoint& other) const
  {
    return this->Owner == other.Owner && this->Key == other.Key;
  }
};

/**
 * @class   SlicedSimplex
 * @brief   a 4-simplex with its vertices in the global order and their codes for the slice value
 */
class SlicedSimplex
{
public:
  using Code = ExtractionValues::Code;
  using Slot = vtkIsotable::Slot;

  static constexpr int Size = 5;
  static constexpr Code AtValue = 1;
  static constexpr Code AboveValue = 2;

  /// Sorts the vertices of a 4-simplex. Of two equal ids, the first one counts as lower.
  template <typename Id>
  void Sort(
    const Id* stored, const Code* codes, const CornerOrder& order, SliceIntersection intersection)
  {
    vtkIdType ids[Size];
    std::copy_n(stored, Size, ids);
    Slot ranks[Size];
    order.Rank(ids, Size, ranks);
    this->IsOdd = false;
    for (int v = 0; v < Size; ++v)
    {
      this->Ids[ranks[v]] = ids[v];
      this->Codes[ranks[v]] = codes[v];
      for (int before = 0; before < v; ++before)
      {
        this->IsOdd ^= ranks[before] > ranks[v];
      }
    }
    if (intersection == SliceIntersection::InSlice)
    {
      // Treat the tetrahedron as the face at which a 4-simplex begins.
      this->Codes[ranks[Size - 1]] = AboveValue;
    }
  }

  /// Returns true if sorting took an odd number of swaps.
  bool IsInverted() const { return this->IsOdd; }

  /// Returns the vertices whose code is at least \a first, as a bit mask.
  unsigned int FindVerticesAtLeast(Code first) const
  {
    unsigned int above = 0;
    for (int v = 0; v < Size; ++v)
    {
      above |= (this->Codes[v] >= first ? 1u : 0u) << v;
    }
    return above;
  }

  /// Returns the slice point on an edge. If an end of the edge is at the value, that end is the
  /// point.
  SlicePoint FindPoint(const std::array<Slot, 2>& edge) const
  {
    for (const Slot end : edge)
    {
      if (this->Codes[end] == AtValue)
      {
        return { this->Ids[end], CrossingKey() };
      }
    }
    const auto ends = std::minmax(this->Ids[edge[0]], this->Ids[edge[1]]);
    return { ends.first, CrossingKey(ends.second, 0) };
  }

private:
  vtkIdType Ids[Size];
  Code Codes[Size];
  bool IsOdd;
};

}

#endif

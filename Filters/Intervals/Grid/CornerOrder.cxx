// SPDX-License-Identifier: BSD-3-Clause
#include "Grid/CornerOrder.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace interlume
{

namespace
{
// Corner permutations of a hexahedron. A permutation is selected by its first corner and by three
// bits that compare the neighbors of this corner along the three axes: second before first, third
// before second, third before first.
struct HexahedronPermutations
{
  std::uint8_t Corners[8][8][8] = {};

  static constexpr HexahedronPermutations Make()
  {
    HexahedronPermutations made;
    for (int exchanges = 0; exchanges < 8; ++exchanges)
    {
      const int secondBeforeFirst = exchanges & 1;
      const int thirdBeforeSecond = (exchanges >> 1) & 1;
      const int thirdBeforeFirst = (exchanges >> 2) & 1;
      int axes[3] = {};
      axes[secondBeforeFirst + thirdBeforeFirst] = 1;
      axes[1 - secondBeforeFirst + thirdBeforeSecond] = 2;
      axes[2 - thirdBeforeSecond - thirdBeforeFirst] = 4;
      for (int corner = 0; corner < 8; ++corner)
      {
        for (int v = 0; v < 8; ++v)
        {
          made.Corners[corner][exchanges][v] = static_cast<std::uint8_t>(
            corner ^ ((v & 1) ? axes[0] : 0) ^ ((v & 2) ? axes[1] : 0) ^ ((v & 4) ? axes[2] : 0));
        }
      }
    }
    return made;
  }
};

// Permutes the ids one by one. Loading pairs of ids just after they were written one by one would
// defeat store-to-load forwarding.
template <std::size_t... V>
void Permute(const std::uint8_t* from, vtkIdType* ids, std::index_sequence<V...>)
{
  const vtkIdType permuted[] = { ids[from[V]]... };
  ((ids[V] = permuted[V]), ...);
}

// Compilers unroll the loops if \a Known, the number of keys, is not 0.
template <int Known>
void RankKeys(const vtkIdType* keys, int number, vtkIsotable::Slot* ranks)
{
  const int end = Known ? Known : number;
  int counts[vtkIsotable::MaximumNumberOfVertices] = {};
  for (int a = 0; a < end; ++a)
  {
    for (int b = a + 1; b < end; ++b)
    {
      const int isLater = keys[b] < keys[a];
      counts[a] += isLater;
      counts[b] += 1 - isLater;
    }
  }
  for (int v = 0; v < end; ++v)
  {
    ranks[v] = static_cast<vtkIsotable::Slot>(counts[v]);
  }
}
}

CornerOrder::CornerOrder(vtkPointData* points)
  : Array(GlobalIds::Get(points))
  , Keys(Array ? Array->GetPointer(0) : nullptr)
{
}

void CornerOrder::Rank(const vtkIdType* ids, int number, vtkIsotable::Slot* ranks) const
{
  vtkIdType buffer[vtkIsotable::MaximumNumberOfVertices];
  const vtkIdType* const keys = this->GetKeys(ids, number, buffer);
  number == 8 ? RankKeys<8>(keys, number, ranks) : RankKeys<0>(keys, number, ranks);
}

void CornerOrder::Turn(vtkIsotable::Shapes shape, vtkIdType* ids) const
{
  switch (shape)
  {
    case vtkIsotable::TETRAHEDRON:
    case vtkIsotable::TRIANGLE:
      std::sort(ids, ids + (shape == vtkIsotable::TRIANGLE ? 3 : 4),
        [this](vtkIdType a, vtkIdType b) { return this->IsBefore(a, b); });
      break;
    case vtkIsotable::QUADRILATERAL:
      break;
    case vtkIsotable::PYRAMID:
      this->PermutePyramid(ids);
      break;
    case vtkIsotable::WEDGE:
      this->PermuteWedge(ids);
      break;
    default:
      this->PermuteHexahedron(ids);
  }
}

void CornerOrder::PermutePyramid(vtkIdType* ids) const
{
  const auto before = [this](vtkIdType a, vtkIdType b) { return this->IsBefore(a, b); };
  std::rotate(ids, std::min_element(ids, ids + 4, before), ids + 4);
  if (before(ids[3], ids[1]))
  {
    std::swap(ids[1], ids[3]);
  }
}

void CornerOrder::PermuteWedge(vtkIdType* ids) const
{
  const auto before = [this](vtkIdType a, vtkIdType b) { return this->IsBefore(a, b); };
  if (std::min_element(ids, ids + 6, before) - ids >= 3)
  {
    std::swap_ranges(ids, ids + 3, ids + 3);
  }
  // Swaps the same two corners in both triangles.
  const auto order = [&](int a, int b)
  {
    if (before(ids[b], ids[a]))
    {
      std::swap(ids[a], ids[b]);
      std::swap(ids[a + 3], ids[b + 3]);
    }
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
}

void CornerOrder::PermuteHexahedron(vtkIdType* ids) const
{
  static constexpr HexahedronPermutations permutations = HexahedronPermutations::Make();
  vtkIdType buffer[8];
  const vtkIdType* const keys = this->GetKeys(ids, 8, buffer);
  int corner = 0;
  vtkIdType least = keys[0];
  for (int v = 1; v < 8; ++v)
  {
    // Branchless, since which corner comes first is unpredictable.
    const bool isBefore = keys[v] < least;
    corner = isBefore ? v : corner;
    least = isBefore ? keys[v] : least;
  }
  const vtkIdType along[3] = { keys[corner ^ 1], keys[corner ^ 2], keys[corner ^ 4] };
  const int exchanges = static_cast<int>(along[1] < along[0]) |
    (static_cast<int>(along[2] < along[1]) << 1) | (static_cast<int>(along[2] < along[0]) << 2);
  Permute(permutations.Corners[corner][exchanges], ids, std::make_index_sequence<8>());
}

}

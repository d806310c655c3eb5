// SPDX-License-Identifier: BSD-3-Clause
#include "TimeVarying/SimplexSliceTable.h"

#include <algorithm>
#include <utility>

namespace interlume
{

namespace
{
using Slice = SimplexSliceTable::Slice;
using Slot = SimplexSliceTable::Slot;

constexpr int NumberOfVertices = 5;
constexpr unsigned int NumberOfCases = 1u << NumberOfVertices;

// The vertices on one side of the hyperplane, then those on the other side, both in ascending
// order.
struct Sides
{
  std::array<Slot, NumberOfVertices> Vertices{};
  int NumberOfFirst = 0;
  // True if Vertices is an odd permutation.
  bool IsOdd = false;
};

Sides Partition(unsigned int first)
{
  Sides sides;
  int number = 0;
  int skipped = 0;
  for (int v = 0; v < NumberOfVertices; ++v)
  {
    if ((first >> v) & 1)
    {
      sides.Vertices[number++] = static_cast<Slot>(v);
      sides.IsOdd ^= (skipped & 1) != 0;
    }
    else
    {
      ++skipped;
    }
  }
  sides.NumberOfFirst = number;
  for (int v = 0; v < NumberOfVertices; ++v)
  {
    if (!((first >> v) & 1))
    {
      sides.Vertices[number++] = static_cast<Slot>(v);
    }
  }
  return sides;
}

Slice Make(unsigned int above)
{
  unsigned int first = above;
  Sides sides = Partition(first);
  if (sides.NumberOfFirst > 2)
  {
    first = ~above & (NumberOfCases - 1);
    sides = Partition(first);
  }
  Slice slice;
  if (sides.NumberOfFirst == 0)
  {
    return slice;
  }
  const int rows = sides.NumberOfFirst;
  const int columns = NumberOfVertices - rows;
  for (int row = 0; row < rows; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      const auto ends = std::minmax(sides.Vertices[row], sides.Vertices[rows + column]);
      slice.Edges[slice.NumberOfSlots++] = { { ends.first, ends.second } };
    }
  }
  // Orientation: the first tetrahedron of a prism is positive if the edge is below the hyperplane.
  // The slice at a single vertex, with its edges in order, is positive if the vertex is above.
  // Consecutive tetrahedra of a prism differ in one point at the same index, so their orientation
  // alternates.
  const bool isFirstInverted = sides.IsOdd != ((first == above) == (rows == 2));
  slice.NumberOfTetrahedra = rows == 1 ? 1 : columns;
  for (int t = 0; t < slice.NumberOfTetrahedra; ++t)
  {
    // Points up to index \a turn are on edges of the first side's first vertex, and all later
    // points are on edges of its last vertex.
    const int turn = columns - 1 - t;
    vtkIsotable::Simplex& points = slice.Tetrahedra[t];
    for (int p = 0; p < 4; ++p)
    {
      points[p] = static_cast<Slot>(p <= turn ? p : columns + p - 1);
    }
    if (isFirstInverted != ((t & 1) != 0))
    {
      std::swap(points[0], points[1]);
    }
  }
  return slice;
}
}

const std::array<SimplexSliceTable::Slice, 32>& SimplexSliceTable::GetAll()
{
  static const std::array<Slice, NumberOfCases> table = []
  {
    std::array<Slice, NumberOfCases> made;
    for (unsigned int key = 0; key < NumberOfCases; ++key)
    {
      made[key] = Make(key);
    }
    return made;
  }();
  return table;
}

}

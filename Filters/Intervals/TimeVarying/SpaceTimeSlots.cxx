// SPDX-License-Identifier: BSD-3-Clause
#include "TimeVarying/SpaceTimeSlots.h"

#include <initializer_list>

namespace interlume
{

namespace
{
// Clears the lowest set bit.
unsigned DropBit(unsigned bits)
{
  return bits & (bits - 1);
}

std::array<unsigned, 6> GetFaces(vtkIsotable::Shapes shape)
{
  const auto bits = [](std::initializer_list<int> corners)
  {
    unsigned all = 0;
    for (int corner : corners)
    {
      all |= 1u << corner;
    }
    return all;
  };
  switch (shape)
  {
    case vtkIsotable::TETRAHEDRON:
      return { { bits({ 1, 2, 3 }), bits({ 0, 2, 3 }), bits({ 0, 1, 3 }), bits({ 0, 1, 2 }) } };
    case vtkIsotable::PYRAMID:
      return { { bits({ 0, 1, 2, 3 }), bits({ 0, 1, 4 }), bits({ 1, 2, 4 }), bits({ 2, 3, 4 }),
        bits({ 3, 0, 4 }) } };
    case vtkIsotable::WEDGE:
      return { { bits({ 0, 1, 2 }), bits({ 3, 4, 5 }), bits({ 0, 1, 3, 4 }), bits({ 1, 2, 4, 5 }),
        bits({ 2, 0, 5, 3 }) } };
    default:
      return { { bits({ 0, 2, 4, 6 }), bits({ 1, 3, 5, 7 }), bits({ 0, 1, 4, 5 }),
        bits({ 2, 3, 6, 7 }), bits({ 0, 1, 2, 3 }), bits({ 4, 5, 6, 7 }) } };
  }
}
}

SpaceTimeSlots::SpaceTimeSlots(vtkIsotable::Shapes shape)
  : Faces(GetFaces(shape))
{
  const SpaceTimeTable& table = SpaceTimeTable::Get(shape);
  const int n = table.GetNumberOfVertices();
  const int m = table.GetNumberOfEdges();
  const int corners = n / 2;
  for (int slot = 0; slot < n + 2 * m; ++slot)
  {
    const std::array<Slot, 2> ends = slot < n
      ? std::array<Slot, 2>{ { static_cast<Slot>(slot), static_cast<Slot>(slot) } }
      : table.GetEdge((slot - n) % m);
    unsigned sides = 0;
    if (slot >= n)
    {
      sides = slot < n + m ? LOWER : UPPER;
    }
    if ((ends[0] < corners) == (ends[1] < corners))
    {
      sides |= ends[0] < corners ? unsigned{ START } : unsigned{ END };
    }
    this->SidesOf[slot] = static_cast<std::uint8_t>(sides);
    const unsigned support = (1u << (ends[0] % corners)) | (1u << (ends[1] % corners));
    this->Supports[slot] = static_cast<std::uint8_t>(support);
    for (int f = 0; f < MaximumNumberOfFaces; ++f)
    {
      this->FacesOf[slot] = static_cast<std::uint8_t>(
        this->FacesOf[slot] | ((support & ~this->Faces[f]) == 0 ? 1u << f : 0u));
    }
  }
}

std::uint8_t SpaceTimeSlots::FindFlatFacets(const Simplex& simplex, unsigned planar) const
{
  constexpr unsigned all = 31;
  unsigned support[5];
  unsigned faces[5];
  for (int i = 0; i < 5; ++i)
  {
    support[i] = this->Supports[simplex[i]];
    faces[i] = this->FacesOf[simplex[i]] & planar;
  }
  unsigned flat = 0;
  for (int a = 0; a < 5; ++a)
  {
    unsigned common = planar;
    for (int b = 0; b < 5; ++b)
    {
      common &= b == a ? planar : faces[b];
    }
    flat |= common ? 1u << a : 0u;
    for (int b = a + 1; b < 5; ++b)
    {
      const unsigned pair = support[a] | support[b];
      const unsigned left = all & ~(1u << a) & ~(1u << b);
      flat |= DropBit(pair) == 0 ? left : 0u;
      for (int c = b + 1; c < 5; ++c)
      {
        flat |= DropBit(DropBit(pair | support[c])) == 0 ? left & ~(1u << c) : 0u;
      }
    }
  }
  return static_cast<std::uint8_t>(flat);
}

}

// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SimplexSliceTable_h
#define interlume_SimplexSliceTable_h

#include "vtkIsotable.h" // for slots and simplices

#include <array>

namespace interlume
{

/**
 * @class   SimplexSliceTable
 * @brief   the slice of a 4-simplex by a hyperplane, for each set of vertices above it
 *
 * Every edge with one end above and one below has a point of the slice, its slot. With one vertex
 * on a side the slice is the tetrahedron of its four edges. With an edge a < b on one side and a
 * triangle c < d < e on the other it is their product, a prism, which is cut along the staircases
 * (ac,ad,ae,be), (ac,ad,bd,be), (ac,bc,bd,be). The cut of a side of the prism follows from the
 * order of that side's own vertices, so that neighbours agree where all take one order of the
 * points.
 *
 * The vertices are numbered in ascending order. Tetrahedra have a positive volume where the
 * vertices in this order are positively oriented in (x,y,z,t) and those of greater t are above.
 */
class SimplexSliceTable
{
public:
  using Slot = vtkIsotable::Slot;

  struct Slice
  {
    int NumberOfTetrahedra = 0;
    int NumberOfSlots = 0;
    std::array<vtkIsotable::Simplex, 3> Tetrahedra{};
    /// The vertices at the ends of each slot's edge, in ascending order.
    std::array<std::array<Slot, 2>, 6> Edges{};
  };

  /// Returns the slices of all sets of vertices: bit v of a slice's number is set where vertex v is
  /// above.
  static const std::array<Slice, 32>& GetAll();
};

}

#endif

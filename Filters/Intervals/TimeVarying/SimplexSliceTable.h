// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SimplexSliceTable_h
#define interlume_SimplexSliceTable_h

#include "vtkIsotable.h" // for slots and simplices

#include <array>

namespace interlume
{

/**
 * @class   SimplexSliceTable
 * @brief   slices of a 4-simplex by a hyperplane, indexed by the set of vertices above it
 *
 * Each edge from a vertex above to a vertex below the hyperplane contains a point of the slice,
 * called a slot. If a single vertex is on one side, the slice is a tetrahedron with a point on each
 * of the vertex's four edges. If an edge a < b is on one side and a triangle c < d < e on the
 * other, the slice is a prism, the product of the edge and the triangle. It is split into the
 * tetrahedra (ac,ad,ae,be), (ac,ad,bd,be) and (ac,bc,bd,be). How a quadrilateral face of the prism
 * is split depends only on the order of the four vertices of the tetrahedron that contains the
 * face. Therefore the slices of adjacent simplices match if all simplices use the same point order.
 *
 * The tetrahedra have positive volume if the vertices in ascending order are positively oriented in
 * (x,y,z,t) and vertices with larger t are above.
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
    /// The two vertices of each slot's edge, in ascending order.
    std::array<std::array<Slot, 2>, 6> Edges{};
  };

  /// Returns all slices. Bit v of the index is set if vertex v is above the hyperplane.
  static const std::array<Slice, 32>& GetAll();
};

}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CentroidOrder_h
#define interlume_CentroidOrder_h

#include "Mesh/TetrahedraMesh.h"
#include "Order/RadixOrder.h"

#include <cstdint>
#include <vector>

namespace interlume
{

/**
 * @class   CentroidOrder
 * @brief   tetrahedra in order of their centroids, front to back
 *
 * The order is by distance of the centroid from the eye in perspective, not by depth along the
 * axis, so that turning the head changes nothing; it is by depth along the direction in parallel.
 * Distances are told apart to single precision of their difference from that of the nearest place
 * of the mesh; equal ones go by the number of the tetrahedron. The order is the same for any number
 * of threads.
 *
 * It is an approximation: two tetrahedra of different size may come out the wrong way round. See
 * VisibilityOrder for an exact order.
 */
class CentroidOrder
{
public:
  /// Fills \a frontToBack with the numbers of all tetrahedra. Working memory is kept for the next
  /// call.
  void Compute(
    const TetrahedraMesh& mesh, const Viewpoint& view, std::vector<std::uint32_t>& frontToBack);

  /// Returns the bytes held, at most 24 a tetrahedron.
  std::size_t GetBytes() const;

private:
  std::vector<std::uint32_t> Keys;
  RadixOrder Radix;
};

}

#endif

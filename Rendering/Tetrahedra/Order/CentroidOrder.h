// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CentroidOrder_h
#define interlume_CentroidOrder_h

#include "Mesh/TetrahedraMesh.h"
#include "Order/RadixSorter.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace interlume
{

/**
 * @class   CentroidOrder
 * @brief   sorts tetrahedra by their centroids, front to back
 *
 * In perspective, the sort key is the squared distance of the centroid from the camera, not the
 * depth along the view axis, so rotating the camera does not change the order. In parallel
 * projection, the key is the depth along the view direction. Keys have single precision. So that
 * they are precise enough for a distant camera, the squared distance between the camera and the
 * bounding sphere is subtracted. Tetrahedra with equal keys are ordered by index. The order does
 * not depend on the number of threads.
 *
 * The order is approximate: tetrahedra of different sizes may be swapped. See VisibilityOrder for
 * an exact order.
 */
class CentroidOrder
{
public:
  /// Fills \a frontToBack with the indices of all tetrahedra. Internal buffers are reused in the
  /// next call. Returns false if \a isAborted, which is called before sorting, returned true.
  bool Compute(const TetrahedraMesh& mesh, const Viewpoint& view,
    std::vector<std::uint32_t>& frontToBack, const std::function<bool()>& isAborted = nullptr);

  /// Returns the memory size in bytes, at most 24 per tetrahedron.
  std::size_t GetBytes() const;

private:
  std::vector<std::uint32_t> Keys;
  RadixSorter Radix;
};

}

#endif

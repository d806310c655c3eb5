// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_VolumeOrder_h
#define interlume_VolumeOrder_h

#include "Plan/SlicePlan.h"

#include <array>
#include <cstddef>
#include <vector>

namespace interlume
{

/**
 * @class   VolumeOrder
 * @brief   the order in which volumes are drawn within a slab
 *
 * If a plane parallel to a box face separates two boxes, the volume on the side of the sweep's
 * first light is drawn first. In a sweep without lights, the volume on the camera's side is drawn
 * first (front to back) or last (back to front). This order is correct for all rays of the first
 * light, or of the camera. For other rays, the error is limited to the extinction within the slab.
 * Overlapping volumes alternate: one is drawn first in even slabs, the other in odd slabs. The
 * errors, which are of first order in the slab's optical depth, then cancel.
 */
class VolumeOrder
{
public:
  /// Computes the drawing order for a sweep. \a lights are the lights of the plan.
  void Find(const SlicePlan::Sweep& sweep, const SlicePlan::Camera& eye,
    const std::vector<LightSource>& lights, const std::vector<SlicePlan::SlicedVolume>& volumes);

  /// Returns the indices of all volumes in drawing order for a slab.
  const std::vector<std::size_t>& Get(int slab) const
  {
    return this->Orders[static_cast<std::size_t>(slab % 2)];
  }

private:
  /// Drawing orders in even and odd slabs.
  std::array<std::vector<std::size_t>, 2> Orders;
};

}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SlabOrder_h
#define interlume_SlabOrder_h

#include "Plan/SlicePlan.h"

#include <array>
#include <cstddef>
#include <vector>

namespace interlume
{

/**
 * @class   SlabOrder
 * @brief   the order in which volumes are drawn within a slab
 *
 * If a plane parallel to a box face separates two boxes, the volume on the light's side is drawn
 * first. Without a light that casts shadows, the sweep's order along the view direction decides.
 * Such an order is correct for all rays of that light, and for other rays the error is limited to
 * the extinction within the slab. Overlapping volumes alternate: one is first in even slabs, the
 * other in odd slabs. The two errors, which are of first order in the slab's optical depth, then
 * cancel.
 */
class SlabOrder
{
public:
  /// Computes the order of a sweep. \a lights are the lights of the plan.
  void Find(const SlicePlan::Sweep& sweep, const SlicePlan::Camera& eye,
    const std::vector<LightSource>& lights, const std::vector<SlicePlan::SlicedVolume>& volumes);

  /// Returns the indices of all volumes in drawing order for a slab.
  const std::vector<std::size_t>& Get(int slab) const
  {
    return this->Orders[static_cast<std::size_t>(slab % 2)];
  }

private:
  /// Orders of even and odd slabs.
  std::array<std::vector<std::size_t>, 2> Orders;
};

}

#endif

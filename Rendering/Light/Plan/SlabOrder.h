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
 * @brief   in which order volumes draw their parts of a slab
 *
 * Where a plane along a face of one box stands between two boxes, the volume on the side that the
 * light comes from is first; without light that casts shadows, the one that the sweep's eye wants
 * first. Such an order is right for each ray of that light, and wrong for others by no more than
 * what is in the slab. Volumes that overlap take turns: one is first in even slabs and the other
 * one in odd slabs, so that the errors of both orders, each of the first order in the slab's
 * optical depth, cancel from slab to slab.
 */
class SlabOrder
{
public:
  /// Finds the orders of a sweep. \a lights are those of the plan.
  void Find(const SlicePlan::Sweep& sweep, const SlicePlan::Eye& eye,
    const std::vector<LightSource>& lights, const std::vector<SlicePlan::Matter>& matter);

  /// Returns the indices of all volumes, as they are drawn in a slab.
  const std::vector<std::size_t>& Get(int slab) const
  {
    return this->Orders[static_cast<std::size_t>(slab % 2)];
  }

private:
  /// Of even and of odd slabs.
  std::array<std::vector<std::size_t>, 2> Orders;
};

}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SlicePolygons_h
#define interlume_SlicePolygons_h

#include "Plan/SlabTriangles.h"
#include "Plan/SlicePlan.h"
#include "Volume/BlockLattice.h"

#include <array>

namespace interlume
{

class UnitSpace;

/**
 * @class   SlicePolygons
 * @brief   where slices cut the blocks that can be seen
 *
 * Computes for each slab the triangles of the plane through its middle inside the visible blocks,
 * in unit space. Neighbouring blocks share the corners of their common edge bit for bit, so that a
 * pixel is covered once. A plane along the common face of two blocks is in the one that the normal
 * points into. Triangles wind either way. Blocks on the outside of the box are larger there by what
 * a ray can enter the slab beside the box's own cut; the shader cuts the ray at the box. Layers of
 * blocks that are visible in the same places are cut as one.
 */
class SlicePolygons : public SlabTriangles
{
public:
  /**
   * Cuts all slabs. \a box is the box of the medium in texture coordinates: blocks outside of it
   * are skipped, others cut at it, and the first and last reach to it. \a margin is the length by
   * which outer blocks are enlarged, in unit space. Threads share the slabs; the triangles are the
   * same for any number of threads.
   */
  void Build(const SlicePlan::Sweep& sweep, BlockLattice lattice, const UnitSpace& space,
    const std::array<std::array<double, 2>, 3>& box, double margin);
};

}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SlicePolygons_h
#define interlume_SlicePolygons_h

#include "Plan/SlabTriangles.h"
#include "Plan/SlicePlan.h"
#include "Volume/BlockGrid.h"

#include <array>

namespace interlume
{

class UnitSpace;

/**
 * @class   SlicePolygons
 * @brief   triangles of the slices inside the visible blocks
 *
 * Computes for each slab the triangles of its central plane inside the visible blocks, in unit
 * space. Adjacent blocks compute bit-identical vertices on a common edge, so each pixel is covered
 * exactly once. If the plane contains the common face of two blocks, it belongs to the block that
 * the normal points into. Triangles can have either winding. Blocks at the border of the box are
 * enlarged to include rays that enter the slab outside the plane's cross-section with the box; the
 * shader clips rays at the box. Adjacent layers of blocks with the same visibility are merged.
 */
class SlicePolygons : public SlabTriangles
{
public:
  /**
   * Computes the triangles of all slabs. \a box is the box of the medium in texture coordinates:
   * blocks outside it are skipped, other blocks are clipped to it, and the first and last blocks
   * extend to it. \a margin is the length in unit space by which outer blocks are enlarged. Slabs
   * are processed in parallel; the result does not depend on the number of threads.
   */
  void Build(const SlicePlan::Sweep& sweep, BlockGrid grid, const UnitSpace& space,
    const std::array<std::array<double, 2>, 3>& box, double margin);
};

}

#endif

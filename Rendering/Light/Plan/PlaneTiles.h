// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PlaneTiles_h
#define interlume_PlaneTiles_h

#include "Plan/SlabTriangles.h"
#include "Plan/SlicePlan.h"
#include "Volume/BlockLattice.h"

#include <array>

#include <glm/mat4x4.hpp>

namespace interlume
{

class UnitSpace;

/**
 * @class   PlaneTiles
 * @brief   which squares of a picture, or of a light's buffer, slices have matter in
 *
 * The picture is cut into squares of TileSize pixels along an edge. A slab's tiles are those that
 * meet what the plane through its middle has of a visible block. Neighbours are one rectangle, and
 * no pixel is in two. Software OpenGL shades whole squares of pixels, whatever part of them a
 * triangle has: the polygons of blocks share most squares, once for each triangle, and these tiles
 * none. Corners are in unit space, in the slices' planes.
 */
class PlaneTiles : public SlabTriangles
{
public:
  /// As many as llvmpipe shades at a time.
  static constexpr int TileSize = 4;

  /**
   * Finds the tiles of all slabs. \a clipFromUnit is the view, \a size the columns and rows of its
   * picture, \a box the box of the matter in texture coordinates, \a margin the length by which its
   * outer blocks are enlarged, in unit space. Threads share the slabs; the tiles are the same for
   * any number of threads. Returns false, and there are no tiles, where some of the box is beside
   * or behind the eye of the view, or slices are seen nearly edge-on.
   */
  bool Build(const SlicePlan::Sweep& sweep, const glm::dmat4& clipFromUnit,
    const std::array<int, 2>& size, BlockLattice lattice, const UnitSpace& space,
    const std::array<std::array<double, 2>, 3>& box, double margin);
};

}

#endif

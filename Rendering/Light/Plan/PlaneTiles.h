// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PlaneTiles_h
#define interlume_PlaneTiles_h

#include "Plan/SlabTriangles.h"
#include "Plan/SlicePlan.h"
#include "Volume/BlockGrid.h"

#include <array>

#include <glm/mat4x4.hpp>

namespace interlume
{

class UnitSpace;

/**
 * @class   PlaneTiles
 * @brief   tiles of an image or light buffer that contain the medium, for each slab
 *
 * The image is divided into squares of TileSize x TileSize pixels. A slab's tiles are the squares
 * that intersect the projection of a visible block's cross-section with the slab's central plane.
 * Adjacent tiles are merged into rectangles; tiles do not overlap. Vertices are in unit space, in
 * the slice planes.
 *
 * Drawing tiles is faster than drawing the polygons of the blocks in software OpenGL, which shades
 * a whole square for each triangle that covers any part of it. Most squares intersect polygons of
 * several blocks.
 */
class PlaneTiles : public SlabTriangles
{
public:
  /// Edge length in pixels of the squares that llvmpipe shades.
  static constexpr int TileSize = 4;

  /**
   * Finds the tiles of all slabs. \a clipFromUnit is the view, \a size the number of columns and
   * rows of its image, \a box the box of the medium in texture coordinates, and \a margin the
   * length in unit space by which outer blocks are enlarged. Slabs are processed in parallel; the
   * result does not depend on the number of threads. Returns false without tiles if part of the box
   * is beside or behind the viewpoint, or if slices are seen nearly edge-on.
   */
  bool Build(const SlicePlan::Sweep& sweep, const glm::dmat4& clipFromUnit,
    const std::array<int, 2>& size, BlockGrid grid, const UnitSpace& space,
    const std::array<std::array<double, 2>, 3>& box, double margin);
};

}

#endif

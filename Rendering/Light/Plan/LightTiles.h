// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LightTiles_h
#define interlume_LightTiles_h

#include "Common/Vectors.h"
#include "Plan/SlabTriangles.h"
#include "Plan/SlicePlan.h"
#include "Volume/BlockGrid.h"

#include <array>

namespace interlume
{

class UnitSpace;

/**
 * @class   LightTiles
 * @brief   tiles of a wide light's buffer whose rays can intersect the medium in a slab
 *
 * The light buffer is divided into squares of about TileSize x TileSize texels. The light rays
 * through a square form a pyramid. A slab's tiles are the squares whose pyramid, clipped to the
 * slab, has a bounding box (in texture coordinates) that intersects a visible block inside the box
 * of the medium. Adjacent tiles in a row are merged into one rectangle. Tiles do not overlap.
 * Vertices are (x, y, 0), with x and y from 0 to 1 across the buffer.
 */
class LightTiles : public SlabTriangles
{
public:
  static constexpr int TileSize = 16;

  /**
   * Finds the tiles of all slabs for a wide light at \a position, in unit space. \a box is the box
   * of the medium in texture coordinates. Slabs are processed in parallel; the result does not
   * depend on the number of threads.
   */
  void Build(const SlicePlan::Sweep& sweep, const SlicePlan::ShadowedLight& light,
    const glm::dvec3& position, const BlockGrid& grid, const UnitSpace& space,
    const std::array<std::array<double, 2>, 3>& box);
};

}

#endif

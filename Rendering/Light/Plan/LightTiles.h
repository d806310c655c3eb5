// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LightTiles_h
#define interlume_LightTiles_h

#include "Common/Vectors.h"
#include "Plan/SlabTriangles.h"
#include "Plan/SlicePlan.h"
#include "Volume/BlockLattice.h"

#include <array>

namespace interlume
{

class UnitSpace;

/**
 * @class   LightTiles
 * @brief   which directions of a wide light can meet matter in a slab
 *
 * The light's buffer is cut into squares of about TileSize texels along an edge, whose directions
 * form a pyramid. A slab's tiles are those of which the pyramid's part in the slab has a bounding
 * box, in texture coordinates, that meets a visible block inside the box of the matter. Neighbours
 * in a row are one rectangle. No texel is in two. Corners are x, y, 0, from 0 to 1 across the
 * buffer.
 */
class LightTiles : public SlabTriangles
{
public:
  static constexpr int TileSize = 16;

  /**
   * Finds the tiles of all slabs of a light at \a position, in unit space, whose buffer is wide.
   * \a box is that of the matter in texture coordinates. Threads share the slabs; the tiles are the
   * same for any number of threads.
   */
  void Build(const SlicePlan::Sweep& sweep, const SlicePlan::ShadowedLight& light,
    const glm::dvec3& position, const BlockLattice& lattice, const UnitSpace& space,
    const std::array<std::array<double, 2>, 3>& box);
};

}

#endif

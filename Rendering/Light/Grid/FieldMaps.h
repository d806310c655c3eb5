// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FieldMaps_h
#define interlume_FieldMaps_h

#include "Scattering/ScatteringField.h"

#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace interlume
{

class MatterGrid;

/**
 * @class   FieldMaps
 * @brief   scattered light in the cells of a grid as a texture of three dimensions has it
 *
 * Maps stand one behind the other along z, with a texel for each cell: Fluence, Lean in the axes of
 * unit space, and Forward of each light. Beyond the middles of the cells at the sides values are
 * theirs, as the solver takes them where it balances what leaves the box.
 */
struct FieldMaps
{
  FieldMaps(const MatterGrid& grid, const ScatteringField& field);

  /// Four floats a texel, the last of them 0: software OpenGL reads these faster than three.
  std::vector<float> Texels;
  /// The texels of one map.
  glm::ivec3 Nodes{ 0 };
  /// From unit space to numbers of texels.
  glm::dmat4 NodeFromUnit{ 1.0 };
};

}

#endif

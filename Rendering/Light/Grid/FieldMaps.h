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
 * Maps stand one behind the other along z: Fluence, Lean in the axes of unit space, and Forward of
 * each light. Around the cells there is one more on each side, whose values are such that what is
 * interpolated on the side of the box is what leaves it: of Fluence that of a diffuse medium with
 * nothing beyond (Marshak's condition: over 1 + 3/4 of the transport depth of a cell), of Forward
 * the straight line through both cells before.
 */
struct FieldMaps
{
  FieldMaps(const MatterGrid& grid, const ScatteringField& field);

  /// Three floats a node.
  std::vector<float> Texels;
  /// The nodes of one map.
  glm::ivec3 Nodes{ 0 };
  /// From unit space to numbers of nodes.
  glm::dmat4 NodeFromUnit{ 1.0 };
};

}

#endif

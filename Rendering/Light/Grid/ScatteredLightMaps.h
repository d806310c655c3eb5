// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ScatteredLightMaps_h
#define interlume_ScatteredLightMaps_h

#include "Scattering/ScatteredLight.h"

#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace interlume
{

class ExtinctionGrid;

/**
 * @class   ScatteredLightMaps
 * @brief   scattered light per grid cell, in the layout of a 3D texture
 *
 * The maps have one texel per cell and are stacked along z: Fluence, NetFlux with components along
 * the axes of unit space, and a Forward map for each light (see ScatteredLight). Positions outside
 * the outermost cell centers are clamped to them. This matches the boundary condition of the
 * solver.
 */
struct ScatteredLightMaps
{
  ScatteredLightMaps(const ExtinctionGrid& grid, const ScatteredLight& field);

  /// Four floats per texel, the last one 0. Software OpenGL reads four floats faster than three.
  std::vector<float> Texels;
  /// Number of texels along each axis of a map.
  glm::ivec3 Nodes{ 0 };
  /// Transform from unit space to the texel indices of a map.
  glm::dmat4 NodeFromUnit{ 1.0 };
};

}

#endif

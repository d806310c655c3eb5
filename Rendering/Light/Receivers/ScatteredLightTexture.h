// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ScatteredLightTexture_h
#define interlume_ScatteredLightTexture_h

#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

class vtkLight;
class vtkTextureObject;

namespace interlume
{

/**
 * @class   ScatteredLightTexture
 * @brief   multiply scattered light of a volume, for surfaces
 */
struct ScatteredLightTexture
{
  /// Maps stacked along z: fluence, net flux (along the axes of world coordinates), and the
  /// forward-scattered light of each light.
  vtkTextureObject* Texture = nullptr;
  /// Number of nodes of a map, and the transform from world coordinates to node indices.
  glm::ivec3 Nodes{ 0 };
  glm::dmat4 NodeFromWorld{ 1.0 };
  /// If true, the maps include fluence and net flux: light scattered in all directions.
  bool HasFluence = false;
  std::vector<vtkLight*> Lights;
  /// Number of cells blocked by opaque surfaces.
  int BlockedCells = 0;
};

}

#endif

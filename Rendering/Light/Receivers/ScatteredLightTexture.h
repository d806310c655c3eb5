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
 * @brief   light from multiple scattering in a volume, for shading surfaces
 */
struct ScatteredLightTexture
{
  /// 3D maps stacked along z: fluence, net flux (in world coordinates), and the forward-scattered
  /// light of each light.
  vtkTextureObject* Texture = nullptr;
  /// Number of nodes of a map along each axis, and the transform from world coordinates to node
  /// indices.
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

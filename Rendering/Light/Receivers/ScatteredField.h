// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ScatteredField_h
#define interlume_ScatteredField_h

#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

class vtkLight;
class vtkTextureObject;

namespace interlume
{

/**
 * @class   ScatteredField
 * @brief   the light that a volume has scattered on and on, for surfaces
 */
struct ScatteredField
{
  /// Maps one behind the other along z: fluence and lean, in the axes of the world, then what goes
  /// on with each light.
  vtkTextureObject* Texture = nullptr;
  /// The nodes of a map, and the way to their numbers from world coordinates.
  glm::ivec3 Nodes{ 0 };
  glm::dmat4 NodeFromWorld{ 1.0 };
  /// Whether there is light in all directions.
  bool HasFluence = false;
  std::vector<vtkLight*> Lights;
  /// The cells that are blocked.
  int BlockedCells = 0;
};

}

#endif

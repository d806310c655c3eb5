// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CasterCells_h
#define interlume_CasterCells_h

#include "Lights/LightSource.h"

#include "vtkType.h"

#include <string>
#include <vector>

#include <glm/vec3.hpp>

class vtkOpenGLRenderWindow;

namespace interlume
{

class MatterGrid;
struct SliceScene;

/**
 * @class   CasterCells
 * @brief   the share of each light that surfaces of a scene leave in the cells of a grid
 *
 * It is found by the same functions of the same maps as in slices, opaque and translucent.
 */
class CasterCells
{
public:
  /// Returns when the maps of the scene were drawn; 0 where surfaces cast no shadows.
  static vtkMTimeType GetTime(const SliceScene* scene);

  /**
   * Computes the shares, a list of cells for each light, empty where nothing takes from it. \a
   * scene has shadows of surfaces. Returns what is wrong, or nothing.
   */
  static std::string Make(vtkOpenGLRenderWindow* window, const SliceScene& scene,
    const MatterGrid& grid, const glm::dmat4& worldFromUnit, const std::vector<LightSource>& lights,
    std::vector<std::vector<glm::vec3>>& shares);
};

}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SurfaceOcclusionGrid_h
#define interlume_SurfaceOcclusionGrid_h

#include "Common/Error.h"
#include "Lights/LightSource.h"

#include "vtkType.h"

#include <vector>

#include <glm/vec3.hpp>

class vtkOpenGLRenderWindow;

namespace interlume
{

class MatterGrid;
struct SliceScene;

/**
 * @class   SurfaceOcclusionGrid
 * @brief   what surfaces of a scene take from light in the cells of a grid
 *
 * The share of each light that they leave is found by the same functions of the same maps as in
 * slices, opaque and translucent. Light that was scattered ends at cells that opaque ones go
 * through.
 */
class SurfaceOcclusionGrid
{
public:
  /// Returns when the maps of the scene were drawn; 0 where surfaces cast no shadows.
  static vtkMTimeType GetTime(const SliceScene* scene);

  /// Marks the cells that the opaque surfaces go through which cast shadows.
  static void Block(const SliceScene& scene, const glm::dmat4& worldFromUnit, MatterGrid& grid);

  /**
   * Computes the shares, a list of cells for each light, empty where nothing takes from it. \a
   * scene has shadows of surfaces. Returns an error if they cannot be drawn.
   */
  static Error Make(vtkOpenGLRenderWindow* window, const SliceScene& scene, const MatterGrid& grid,
    const glm::dmat4& worldFromUnit, const std::vector<LightSource>& lights,
    std::vector<std::vector<glm::vec3>>& shares);
};

}

#endif

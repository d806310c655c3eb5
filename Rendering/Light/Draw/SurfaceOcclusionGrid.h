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

class ExtinctionGrid;
struct SliceScene;

/**
 * @class   SurfaceOcclusionGrid
 * @brief   computes the fraction of light that surfaces of a scene transmit to each cell of a grid
 *
 * The transmitted fraction of each light is evaluated with the same shadow maps and shader
 * functions as for slices, for opaque and translucent surfaces. Cells that opaque surfaces
 * intersect absorb scattered light.
 */
class SurfaceOcclusionGrid
{
public:
  /// Returns the time at which the scene's shadow maps were drawn, or 0 if surfaces cast no
  /// shadows.
  static vtkMTimeType GetTime(const SliceScene* scene);

  /// Marks the cells intersected by opaque surfaces that cast shadows.
  static void Block(const SliceScene& scene, const glm::dmat4& worldFromUnit, ExtinctionGrid& grid);

  /**
   * Computes \a transmitted: for each light, the transmitted fraction in each cell, or an empty
   * list if no surface blocks the light. Call this only if GetTime(&scene) is above 0. Returns an
   * error if drawing fails.
   */
  static Error Make(vtkOpenGLRenderWindow* window, const SliceScene& scene,
    const ExtinctionGrid& grid, const glm::dmat4& worldFromUnit,
    const std::vector<LightSource>& lights, std::vector<std::vector<glm::vec3>>& transmitted);
};

}

#endif

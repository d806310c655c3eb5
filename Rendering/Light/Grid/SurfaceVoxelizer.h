// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SurfaceVoxelizer_h
#define interlume_SurfaceVoxelizer_h

#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace interlume
{

class ExtinctionGrid;

/**
 * @class   SurfaceVoxelizer
 * @brief   marks the grid cells that triangles intersect
 *
 * A cell is marked if it contains a part of a triangle. Therefore no light leaks between the cells
 * of a surface, even if the surface is thin. A cell includes its lower faces but not its upper
 * ones: a surface between two layers of cells marks only one layer. Surfaces within 1e-6 cells of
 * the box's faces mark no cell.
 */
class SurfaceVoxelizer
{
public:
  /**
   * Marks cells in ScatteringMedium::Blocked. Allocates that array when the first cell is marked.
   * \a corners (three per triangle) and the clipping planes \a planes are in world coordinates, as
   * in PropSurfaces. Triangles with NaN or infinite coordinates are skipped.
   */
  static void Mark(const std::vector<glm::dvec3>& corners, const std::vector<glm::dvec4>& planes,
    const glm::dmat4& worldFromUnit, ExtinctionGrid& grid);
};

}

#endif

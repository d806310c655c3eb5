// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SurfaceCells_h
#define interlume_SurfaceCells_h

#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace interlume
{

class MatterGrid;

/**
 * @class   SurfaceCells
 * @brief   the cells of a grid that triangles go through
 *
 * A cell is marked where a part of a triangle lies in it, so that no light passes between the cells
 * of a sheet, however thin. A cell has its lower sides and not its upper ones: a sheet between two
 * layers of cells marks one of them. What lies in the sides of the box, by 1e-6 of a cell, marks
 * none.
 */
class SurfaceCells
{
public:
  /**
   * Marks cells of ScatteringMedium::Blocked, which it makes where it is empty and there is
   * something to mark. \a corners and \a planes, beyond which nothing is, are in world coordinates,
   * as PropSurfaces has them. Triangles with NaN or infinity mark none.
   */
  static void Mark(const std::vector<glm::dvec3>& corners, const std::vector<glm::dvec4>& planes,
    const glm::dmat4& worldFromUnit, MatterGrid& grid);
};

}

#endif

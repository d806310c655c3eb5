// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CellLight_h
#define interlume_CellLight_h

#include "Scattering/ScatteringLight.h"
#include "Scattering/ScatteringMedium.h"

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace interlume
{

/**
 * @class   CellLight
 * @brief   computes the mean transmittance of a light in each cell
 *
 * Traces several rays from the light through each cell face on the boundary of the box. The mean of
 * a cell is computed from all rays that cross it. With the transmittance T where a ray enters the
 * cell, and the ray's length s and optical depth tau inside the cell,
 *
 *   mean = (sum of w s T (1 - exp(-tau)) / tau) / (sum of w s),
 *
 * where w is the cross-sectional area that a ray represents. Therefore extinction times mean times
 * volume equals the light that the rays lose in the cell, for any optical depth and at grazing
 * incidence. A single ray through each cell's center would leave cells dark under light at grazing
 * incidence if the mean free path is shorter than a cell.
 */
namespace CellLight
{
/// Returns the number of rays along each edge of a cell face: 2, or up to 16 in small grids.
int GetRaysPerEdge(const glm::ivec3& cells);
/**
 * Returns the mean transmittance of each cell. \a fractions holds the fraction of each cell's
 * extinction that affects red, green and blue; if it is empty, all extinction affects each channel.
 * Only the position or direction of \a light is used. There are \a rays times \a rays rays per cell
 * face, shifted by \a offset times the ray spacing. Blocked cells, and cells in their shadow, are
 * dark.
 */
std::vector<glm::vec3> Find(const ScatteringMedium& medium, const std::vector<glm::vec3>& fractions,
  const ScatteringLight& light, int rays, const glm::dvec2& offset = glm::dvec2(0.0));
}

}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LightSlopes_h
#define interlume_LightSlopes_h

#include "Scattering/MatterCells.h"

#include <vector>

#include <glm/vec3.hpp>

namespace interlume
{

/**
 * How light is attenuated within cells, which may hold more matter than light comes through: it is
 * scattered where it enters them.
 */
namespace LightSlopes
{
/**
 * Returns for each cell and axis the logarithm of the light at its lower side over that at its
 * upper side, the mean of \a lights. It is found from the neighbours' light
 * and is at most the cell's own depth.
 */
std::vector<glm::vec3> Find(
  const MatterCells& matter, const std::vector<std::vector<glm::vec3>>& lights);
/// Returns how far from the middle of a cell light is scattered on the whole, in cells.
double GetOffset(double slope);
}

}

#endif

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
 * @brief   computes what matter leaves of a light in the cells of a medium, as the mean over each
 *
 * Rays go from the light through the box, several for each cell's side, and each counts in all
 * cells on its way: with T where it enters a cell, and the depth tau of its way s there,
 *
 *   mean = sum of w s T (1 - exp(-tau)) / tau   over   sum of w s,
 *
 * where w is the area across the ray that it stands for. What cells take, extinction times mean
 * times volume, is so what rays lose in them, however thick cells are and however light grazes: one
 * ray through a cell's middle finds the cells at a side that light grazes dark where a free path is
 * shorter than a cell.
 */
namespace CellLight
{
/// Returns the number of rays along an edge of a cell's side: two, or more where cells are few.
int CountRays(const glm::ivec3& cells);
/**
 * Returns the means. \a parts are the shares of each cell's extinction that take from red, green
 * and blue, or empty where it is all of it for all; \a light has a place or a direction. There are
 * \a rays times \a rays rays for each cell's side, so far from the middles of their parts of it as
 * \a offset says, in parts. Blocked cells are dark, and what lies behind them.
 */
std::vector<glm::vec3> Find(const ScatteringMedium& medium, const std::vector<glm::vec3>& parts,
  const ScatteringLight& light, int rays, const glm::dvec2& offset = glm::dvec2(0.0));
}

}

#endif

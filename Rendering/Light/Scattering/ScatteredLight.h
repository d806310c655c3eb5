// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ScatteredLight_h
#define interlume_ScatteredLight_h

#include <vector>

#include <glm/vec3.hpp>

namespace interlume
{

/**
 * @class   ScatteredLight
 * @brief   scattered light in the cells of a medium
 *
 * The light that the medium scatters at position x into direction w is
 *
 *   source(x, w) = albedo(x) [ sum_i (L_i T_i(x) + Forward_i(x)) 4 pi p(cos_i) +
 *                              Fluence(x) (1 + 3 g dot(NetFlux(x), w)) ]
 *
 * L_i T_i is light that arrives from light i unscattered, with the unscaled transmittance
 * exp(-depth). cos_i is the cosine of the angle between its direction and w. The phase function p
 * and its mean cosine g are unscaled. The terms do not overlap. Integrated along view rays with the
 * unscaled transmittance, source(x, w) is all scattered light that a camera sees.
 * - Forward_i is scattered light that still travels approximately in the direction of light i. In
 *   mode Forward, it is all multiply scattered light, including lateral spread. In mode Full, it is
 *   the light in the forward peak of the phase function: delta scaling assigns it the fraction f of
 *   the scattered light, and L_i T_i + Forward_i is attenuated by exp(-depth (1 - albedo f)).
 * - Fluence and NetFlux describe the remaining light in all directions, in mode Full. Fluence is
 *   4 pi times the mean radiance. NetFlux is the normalized net flux: the net flux divided by the
 *   fluence. Its length is at most 1/3, so that source(x, w) is never negative.
 *
 * All values are relative to an unattenuated light of color 1.
 */
struct ScatteredLight
{
  std::vector<glm::vec3> Fluence;
  std::vector<glm::vec3> NetFlux;
  /// For each light, one value per cell. Empty if no light is scattered forward.
  std::vector<std::vector<glm::vec3>> Forward;
};

}

#endif

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
 * The light last scattered at position x into direction w is
 *
 *   source(x, w) = albedo(x) [ sum_i (L_i T_i(x) + Forward_i(x)) 4 pi p(cos_i) +
 *                              Fluence(x) (1 + 3 g dot(NetFlux(x), w)) ]
 *
 * L_i T_i is the unscattered light of source i, with unscaled transmittance exp(-depth); cos_i is
 * the cosine between its direction and w. The phase function p and its mean cosine g are unscaled.
 * The terms are disjoint and complete: integrated along view rays with the unscaled transmittance
 * exp(-depth), the sources are all the light that the medium scatters.
 * - Forward_i is scattered light that still travels approximately in the direction of light i. In
 *   mode Forward it is all multiple scattering, including lateral spread. In mode Full it is the
 *   forward peak of the phase function: delta scaling assigns it the fraction f of the scattered
 *   light, and L_i T_i + Forward_i is attenuated by exp(-depth (1 - albedo f)).
 * - Fluence and NetFlux are light in all directions, in mode Full. Fluence is 4 pi times the mean
 *   radiance. NetFlux is the normalized net flux: the net flux divided by the fluence. Its length
 *   is at most 1/3, so that no source is negative.
 *
 * All values are relative to an unattenuated light of color 1.
 */
struct ScatteredLight
{
  std::vector<glm::vec3> Fluence;
  std::vector<glm::vec3> NetFlux;
  /// For each light, a value per cell. Empty if the phase function has no forward peak.
  std::vector<std::vector<glm::vec3>> Forward;
};

}

#endif

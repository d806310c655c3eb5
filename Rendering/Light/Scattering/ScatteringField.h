// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ScatteringField_h
#define interlume_ScatteringField_h

#include <vector>

#include <glm/vec3.hpp>

namespace interlume
{

/**
 * @class   ScatteringField
 * @brief   the light in the cells of a medium that was scattered before
 *
 * Light that leaves a place x in direction w has been scattered there last:
 *
 *   source(x, w) = albedo(x) [ sum_i (L_i T_i(x) + Forward_i(x)) 4 pi p(cos_i) +
 *                              Fluence(x) (1 + 3 g dot(Lean(x), w)) ]
 *
 * L_i T_i is light i as it is without scattering, exp(-depth) not scaled, and cos_i the cosine
 * between its direction and w; p the phase function and g its mean cosine, neither scaled. The
 * parts do not overlap and nothing is missing, so that what the sources send out, attenuated by
 * exp(-depth) to the eye without any scaling, is the light that the medium scatters:
 *  - Forward_i is light that was scattered, but so little out of its way that it goes on as light
 *    i does. In mode FORWARD that is all there is, with its lateral spread. In mode FULL it is the
 *    light in the peak of a forward phase function: delta scaling gives the share f of the
 *    scattered light to it, and L_i T_i + Forward_i together are attenuated by
 *    exp(-depth (1 - albedo f)).
 *  - Fluence and Lean are light in all directions, of mode FULL: Fluence is 4 pi times the mean
 *    radiance, Lean the net flux over the fluence, and so in which direction more of it goes. Lean
 *    is at most 1/3 long so that no source is negative.
 *
 * All values are 1 where light is as bright as a light of colour 1 that nothing attenuates.
 */
struct ScatteringField
{
  std::vector<glm::vec3> Fluence;
  std::vector<glm::vec3> Lean;
  /// A list of values for each light, empty for all where the phase function has no forward peak.
  std::vector<std::vector<glm::vec3>> Forward;
};

}

#endif

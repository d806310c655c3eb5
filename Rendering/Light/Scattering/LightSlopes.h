// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LightSlopes_h
#define interlume_LightSlopes_h

#include "Scattering/SanitizedMedium.h"

#include <vector>

#include <glm/vec3.hpp>

namespace interlume
{

/**
 * Estimates the attenuation of light within cells. In optically thick cells, light is scattered
 * near the face through which it enters.
 */
namespace LightSlopes
{
/**
 * Returns, for each cell and axis, the logarithm of the ratio of the light at the lower face to the
 * light at the upper face, averaged over \a lights. It is estimated from neighboring cells, and its
 * absolute value is at most the optical depth of the cell along the light.
 */
std::vector<glm::vec3> Find(
  const SanitizedMedium& medium, const std::vector<std::vector<glm::vec3>>& lights);
/// Returns the mean offset of scattering events from the cell center along an axis, in cells, for a
/// slope from Find.
double GetOffset(double slope);
}

}

#endif

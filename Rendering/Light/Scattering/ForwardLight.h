// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ForwardLight_h
#define interlume_ForwardLight_h

#include "Scattering/SanitizedMedium.h"

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

namespace interlume
{

/**
 * @class   ForwardLight
 * @brief   computes forward scattering, layer by layer along the light
 *
 * Implements the recurrence 2.19 of C. Zhang's dissertation: the light incident on a layer is what
 * the previous layer transmits and forward-scatters, spread by a convolution. Along the light's
 * path s, the forward-scattered light P satisfies
 *
 *   dP/ds = -(extinction) (1 - albedo fraction) P + extinction albedo fraction Direct,
 *
 * which is solved exactly within a cell. A layer consists of the cells between two planes across
 * the axis closest to the light direction. Between mirrors, cells repeat periodically. For a
 * positional light, each cell has its own such axis, and cells are visited in the order of their
 * distance from the light along it.
 *
 * The convolution between two layers follows Fermi and Eyges. Each scattering event increases the
 * variance of the angle. Light carries the variance of its angle and the covariance of angle and
 * position, so that the variance of position grows with the cube of the distance for any layer
 * thickness. Kernels have exactly this variance if the light is parallel to an axis. For oblique
 * light a kernel is at least as wide as the cells; the excess is subtracted in the following
 * layers. Light spread to neighbors is removed from its cell of origin, so that the sum does not
 * grow.
 *
 * Layers extend past the box by a quarter of its width, since kernels return some of the light that
 * leaves the box. For a positional light, kernels reach one cell per layer, which limits the
 * spread, and light that leaves the box is lost.
 */
class ForwardLight
{
public:
  /**
   * \a fraction is the forward-scattered fraction of the scattered light. \a variance is the
   * variance added per scattering event to the angle along each of two transverse axes, in square
   * radians. Returns the fluence of each cell and adds the number of layers to \a layers.
   */
  static std::vector<glm::vec3> Solve(const SanitizedMedium& medium, std::size_t light,
    double fraction, double variance, int& layers);
};

}

#endif

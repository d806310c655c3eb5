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
 * Implements recurrence 2.19 of C. Zhang's dissertation: the light incident on a layer is what the
 * previous layer transmits and forward-scatters, spread by a convolution. Along the light's path s,
 * the forward-scattered light P satisfies
 *
 *   dP/ds = -(extinction) (1 - albedo fraction) P + extinction albedo fraction Direct,
 *
 * where fraction is the argument of Solve. The equation is solved exactly within a cell. Layers are
 * one cell thick and perpendicular to the axis closest to the light direction. Between mirrors,
 * cells repeat periodically. For a positional light, this axis differs between cells, and cells are
 * visited in the order of their distance from the light along it.
 *
 * The convolution between two layers follows Fermi and Eyges. Each scattering event increases the
 * variance of the angle. Each beam stores the variance of its angle and the covariance of angle and
 * position, so that the variance of position grows with the cube of the distance for any layer
 * thickness. Kernels have exactly this variance if the light is parallel to an axis. For oblique
 * light, a kernel is at least as wide as a cell; the excess is subtracted in the following layers.
 * Light spread to neighbors is removed from its cell of origin, so that the sum does not grow.
 *
 * Layers extend past the box by a quarter of its width, since kernels spread some of the light that
 * leaves the box back into it. For a positional light, kernels reach only one cell per layer, which
 * limits the spread, and light that leaves the box is lost.
 */
class ForwardLight
{
public:
  /**
   * Returns the fluence of forward-scattered light in each cell. Adds the number of layers to
   * \a layers. \a fraction is the part of the scattered light that is scattered forward.
   * \a variance is the variance that each scattering event adds to the angle along each of two
   * transverse axes, in squared radians.
   */
  static std::vector<glm::vec3> Solve(const SanitizedMedium& medium, std::size_t light,
    double fraction, double variance, int& layers);
};

}

#endif

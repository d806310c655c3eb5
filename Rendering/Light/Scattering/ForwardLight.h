// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ForwardLight_h
#define interlume_ForwardLight_h

#include "Scattering/MatterCells.h"

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

namespace interlume
{

/**
 * @class   ForwardLight
 * @brief   computes the light that is scattered on in the direction of its source, layer by layer
 *
 * This is the recurrence 2.19 of the source: what is incident on a layer is what the layer before
 * lets through and what it scatters on, spread by a convolution. Along the light's path s
 *
 *   dP/ds = -(extinction) (1 - albedo share) P + extinction albedo share Direct,
 *
 * solved exactly within a cell. Layers are those of cells across the axis that the light is closest
 * to; between mirrors cells are repeated without end. For a light at a place, the cells in the
 * order of their distance along these axes.
 *
 * The convolution between two layers is that of Fermi and Eyges: each scattering adds to the
 * variance of angle, and light carries the variance of its angle and the covariance of angle and
 * place, so that the variance of place grows with the cube of the distance, whatever the layers.
 * Kernels have this variance exactly for light along an axis; for other light a kernel across the
 * cells is no narrower than the cells are, and what is too much is taken from the layers that
 * follow. Light that goes to neighbours is taken from where it was, so that its sum does not grow.
 * Layers go on beside the box for a quarter of its width, since kernels bring some of the light
 * there back. For a light at a place, kernels reach one cell in a layer, which bounds the spread,
 * and what leaves the box is lost.
 */
class ForwardLight
{
public:
  /**
   * \a share is the part of the scattered light that goes on, \a variance that of the angle to each
   * of two axes for each scattering, in square radians. Returns the fluence in each cell, and the
   * number of layers added to \a layers.
   */
  static std::vector<glm::vec3> Solve(
    const MatterCells& matter, std::size_t light, double share, double variance, int& layers);
};

}

#endif

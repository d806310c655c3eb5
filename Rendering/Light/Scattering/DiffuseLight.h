// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_DiffuseLight_h
#define interlume_DiffuseLight_h

#include "Scattering/SanitizedMedium.h"

#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace interlume
{

/**
 * @class   DiffuseLight
 * @brief   computes multiple scattering in all directions by diffusion
 *
 * Solves the first two moments of the radiative transfer equation (delta-Eddington), with the
 * fluence phi, net flux F, extinction e, albedo a, and the phase function's mean cosine g and
 * forward-peak fraction f:
 *
 *   div F + e (1 - a) phi          = e a (1 - f) sum_i D_i
 *   grad phi / 3 + e (1 - a g) F   = e a (g - f) sum_i D_i d_i
 *
 * The right-hand sides are the light scattered from light i. D_i is the light that still travels in
 * direction d_i, with delta-scaled transmittance exp(-depth (1 - a f)). No light enters at the
 * boundary of the box or at blocked cells (Marshak condition): the outward flux is phi / 2.
 *
 * Cells that are optically much thinner than the medium's average, such as the cells around a
 * cloud, let light escape as the boundary of the box does. They get a sink that makes the flux out
 * of adjacent thick cells phi / 2. Without this sink, diffusion would redistribute light in empty
 * space.
 */
class DiffuseLight
{
public:
  struct Input
  {
    /// Mean cosine g of the phase function, and fraction f in its forward peak.
    double Cosine = 0.0;
    double Peak = 0.0;
    /// The lights D_i: for each light, a value per cell.
    std::vector<std::vector<glm::vec3>> Lights;
    /// Result of LightSlopes::Find.
    std::vector<glm::vec3> Slopes;
    /// Approximate number of cell layers that backscattered light can cross before it is dropped.
    /// If 0, all of it is kept.
    int BackwardLayers = 0;
    double Tolerance = 1e-3;
    int MaximumCycles = 100;
  };
  struct Output
  {
    /// Fluence at the cell's center or, in a thick cell, as seen from outside.
    std::vector<glm::vec3> Fluence;
    /// Fluence that solves the equations; the medium absorbs a fraction of this.
    std::vector<glm::vec3> Mean;
    /// Net flux divided by the mean fluence, averaged over the color channels; length at most 1/3.
    std::vector<glm::vec3> NetFlux;
    /// Rate at which BackwardLayers drops fluence in each cell, per world unit.
    std::vector<float> Drop;
    int Cycles = 0;
    double Residual = 0.0;
  };

  static Output Solve(const SanitizedMedium& medium, const Input& input);
};

}

#endif

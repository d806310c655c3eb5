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
 * Solves the equations of the first two moments of radiative transfer (delta-Eddington). phi is the
 * fluence, F the net flux, e the extinction, a the albedo, g the mean cosine of the phase function,
 * and f the fraction in its forward peak:
 *
 *   div F + e (1 - a) phi          = e a (1 - f) sum_i D_i
 *   grad phi / 3 + e (1 - a g) F   = e a (g - f) sum_i D_i d_i
 *
 * The right-hand sides are the scattered light of all lights i. D_i is the light that still travels
 * in the light's direction d_i, with the delta-scaled transmittance exp(-depth (1 - a f)). No light
 * enters through the boundary of the box or from blocked cells: the outward flux there is phi/2
 * (Marshak condition).
 *
 * Light also escapes into cells that are optically much thinner than the average of the medium,
 * such as the cells around a cloud. A sink in each thin cell makes the flux into it from adjacent
 * thick cells phi/2. Without these sinks, diffusion would redistribute light in empty space.
 */
class DiffuseLight
{
public:
  struct Input
  {
    /// Mean cosine g of the phase function, and fraction f in its forward peak.
    double Cosine = 0.0;
    double Peak = 0.0;
    /// The light D_i of each light i, one value per cell.
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
    /// Fluence phi that solves the equations, for computing the absorbed energy.
    std::vector<glm::vec3> Mean;
    /// Net flux divided by the mean fluence, averaged over the color channels; length at most 1/3.
    std::vector<glm::vec3> NetFlux;
    /// Fraction of fluence per world unit that each cell drops because of BackwardLayers. Empty if
    /// BackwardLayers is 0.
    std::vector<float> Drop;
    int Cycles = 0;
    double Residual = 0.0;
  };

  static Output Solve(const SanitizedMedium& medium, const Input& input);
};

}

#endif

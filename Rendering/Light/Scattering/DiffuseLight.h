// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_DiffuseLight_h
#define interlume_DiffuseLight_h

#include "Scattering/MatterCells.h"

#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace interlume
{

/**
 * @class   DiffuseLight
 * @brief   computes scattered light in all directions by diffusion
 *
 * These are the first two moments of the equation of transport (delta-Eddington): with the fluence
 * phi, the net flux F, the extinction e, the albedo a, the phase function's mean cosine g and
 *
 *   div F + e (1 - a) phi = e a (1 - f) sum_i D_i                   (what is scattered from light
 * i) grad phi / 3 + e (1 - a g) F = e a (g - f) sum_i D_i d_i
 *
 * where D_i is the light that still goes in the direction d_i, so little attenuated as delta
 * scaling has it: exp(-depth (1 - a f)). On the sides of the box and on blocked cells no light
 * comes back (Marshak): the flux out of the medium is phi / 2.
 *
 * Light leaves cells that have much less matter than the medium on average, such as those around a
 * cloud, as it leaves the box: there the equations have a sink of the strength at which the flux
 * out of thicker matter is phi / 2. Diffusion would let the light go to and fro in empty space.
 */
class DiffuseLight
{
public:
  struct Input
  {
    /// The mean cosine g and the share f of the forward peak.
    double Cosine = 0.0;
    double Peak = 0.0;
    /// The lights D_i, in each cell.
    std::vector<std::vector<glm::vec3>> Lights;
    /// Those of LightSlopes.
    std::vector<glm::vec3> Slopes;
    /// Light that has come through about so many layers of cells is dropped; 0 is none.
    int BackwardLayers = 0;
    double Tolerance = 1e-3;
    int MaximumCycles = 100;
  };
  struct Output
  {
    /// The fluence in a cell's middle and, where it is thick, as it is seen from outside.
    std::vector<glm::vec3> Fluence;
    /// The fluence that the equations have in a cell, of which matter absorbs.
    std::vector<glm::vec3> Mean;
    /// The net flux, the mean of the colors, over the mean fluence; at most 1/3 long.
    std::vector<glm::vec3> Lean;
    /// Of BackwardLayers, for each cell: what is dropped over the fluence, in 1 / world unit.
    std::vector<float> Drop;
    int Cycles = 0;
    double Residual = 0.0;
  };

  static Output Solve(const MatterCells& matter, const Input& input);
};

}

#endif

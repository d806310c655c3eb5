// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_OrdinateSweep_h
#define interlume_OrdinateSweep_h

#include "Scattering/DiffuseLight.h"
#include "Scattering/SanitizedMedium.h"

namespace interlume
{

/**
 * @class   OrdinateSweep
 * @brief   improves diffuse light by one sweep of the radiative transfer equation
 *
 * Diffusion lets light bypass dense regions through thin cells next to them. Diffuse light is also
 * too uniform if the mean free path is comparable to the width of the medium. Therefore, the sweep
 * propagates scattered light once along 24 directions (level-symmetric S4: B. G. Carlson, K. D.
 * Lathrop, "Transport theory, the method of discrete ordinates", 1965). The scattered light is
 * computed from the lights and the diffusion solution. With the symbols of DiffuseLight, the sweep
 * solves
 *
 *   w . grad I + e (1 - a f) I = e a max(0, (1 - f) (phi + sum_i D_i) +
 *                                           3 (g - f) (phi NetFlux + sum_i D_i d_i) . w)
 *
 * for the radiance I in each direction w by upwind differences. The mean of I over the directions
 * is the new fluence. The mean of I w, divided by the new fluence, is the new normalized net flux.
 * In each cell, the new values have the weight exp(-1.5 e (1 - f) size), and the diffusion solution
 * has the rest, since upwind differences are less accurate than diffusion in thick cells. No light
 * enters through the boundary. If the box has mirrors, nothing is changed.
 */
namespace OrdinateSweep
{
/// Updates Fluence, Mean and NetFlux of \a output.
void Improve(
  const SanitizedMedium& medium, const DiffuseLight::Input& input, DiffuseLight::Output& output);
}

}

#endif

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
 * too uniform if the mean free path is comparable to the width of the medium. Therefore the light
 * scattered from the lights and from the diffusion solution is followed once along 24 directions
 * (level-symmetric S4: B. G. Carlson, K. D. Lathrop, "Transport theory, the method of discrete
 * ordinates", 1965). With extinction e, albedo a, and mean cosine g and forward peak f of
 * DiffuseLight:
 *
 *   w . grad I + e (1 - a f) I = e a max(0, (1 - f) (phi + sum_i D_i) +
 *                                           3 (g - f) (phi NetFlux + sum_i D_i d_i) . w)
 *
 * solved by upwind differences. The mean of I over the directions is the new fluence. The mean of
 * the product I w, divided by this fluence, is the new normalized net flux. In each cell, these new
 * values get the weight exp(-1.5 e (1 - f) size), and the diffusion solution gets the rest, since
 * upwind differences are less accurate than diffusion in thick cells. No light enters through the
 * boundary. A box with mirrors is left unchanged.
 */
namespace OrdinateSweep
{
/// Updates the fluence, mean and normalized net flux of \a output.
void Improve(
  const SanitizedMedium& medium, const DiffuseLight::Input& input, DiffuseLight::Output& output);
}

}

#endif

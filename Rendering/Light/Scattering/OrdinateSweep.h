// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_OrdinateSweep_h
#define interlume_OrdinateSweep_h

#include "Scattering/DiffuseLight.h"
#include "Scattering/MatterCells.h"

namespace interlume
{

/**
 * @class   OrdinateSweep
 * @brief   improves light in all directions by one sweep of the equation of transport
 *
 * Diffusion lets light go around matter by what is thin at its sides, and is too even where a free
 * path is as long as the matter is wide. What diffused light and the lights scatter is followed
 * once along 48 directions (level-symmetric, S6: B. G. Carlson, K. D. Lathrop, "Transport theory,
 * the method of discrete ordinates", 1965), with the extinction e, the albedo a, the phase
 * function's mean cosine g and forward peak f of DiffuseLight:
 *
 *   w . grad I + e (1 - a f) I = e a max(0, (1 - f) (phi + sum_i D_i) +
 *                                           3 (g - f) (phi lean + sum_i D_i d_i) . w)
 *
 * by upwind differences. The mean of I over the directions is the new fluence, the mean of I w over
 * it the new lean. They count by exp(-1.5 e (1 - f) size) in a cell, and diffusion for the rest: in
 * cells that are thick upwind differences say less than diffusion does. Nothing comes in by the
 * sides of the box, so that a box with mirrors is left as it is.
 */
namespace OrdinateSweep
{
/// Changes the fluence, mean and lean of \a output.
void Improve(
  const MatterCells& matter, const DiffuseLight::Input& input, DiffuseLight::Output& output);
}

}

#endif

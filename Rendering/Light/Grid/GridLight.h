// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_GridLight_h
#define interlume_GridLight_h

#include "Lights/LightSource.h"
#include "Scattering/ScatteringLight.h"

namespace interlume
{

class ExtinctionGrid;

/**
 * @class   GridLight
 * @brief   unscattered light of one source in the cells of a grid
 *
 * CellLight computes the mean transmittance of each cell by tracing rays through the cells. Shadows
 * therefore have the resolution of the cells, even for lights inside the volume. The light's cone,
 * attenuation with distance and screen are evaluated at the centers of a cell's eight octants. For
 * an area light, the contributions of its samples are added. The result is multiplied by the
 * strength of the light's shadows.
 */
class GridLight
{
public:
  /// \a samples is the number of samples of an area light's emitter.
  static ScatteringLight Make(const ExtinctionGrid& grid, const LightSource& light, int samples);
};

}

#endif

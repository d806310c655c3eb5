// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_GridLight_h
#define interlume_GridLight_h

#include "Lights/LightSource.h"
#include "Scattering/ScatteringLight.h"

namespace interlume
{

class MatterGrid;

/**
 * @class   GridLight
 * @brief   the light of one source in the cells of a grid, before it is scattered
 *
 * It is the mean of what matter leaves over each cell, by CellLight's rays through the cells, so
 * that light is as sharp as cells are, inside the volume too. Cone, attenuation and screen are
 * those of the middle of eight parts of a cell. An area light is the mean of its samples. All of it
 * is times the share of the light that casts shadows.
 */
class GridLight
{
public:
  /// \a samples of the emitter of an area light.
  static ScatteringLight Make(const MatterGrid& grid, const LightSource& light, int samples);
};

}

#endif

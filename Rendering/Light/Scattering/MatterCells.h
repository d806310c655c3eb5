// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_MatterCells_h
#define interlume_MatterCells_h

#include "Scattering/ScatteringLight.h"
#include "Scattering/ScatteringMedium.h"

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

namespace interlume
{

/**
 * @class   MatterCells
 * @brief   a medium and its lights with finite values alone
 *
 * Values that are no finite numbers and cells that are blocked have become 0, albedos are 0 to 1.
 */
struct MatterCells
{
  MatterCells(const ScatteringMedium& medium, const std::vector<ScatteringLight>& lights);

  /// The cells' sizes, sides and blocked cells; without values.
  ScatteringMedium Box;
  std::vector<float> Extinction;
  std::vector<glm::vec3> Albedo;
  /// The light in the cells, for each light.
  std::vector<std::vector<glm::vec3>> Direct;
  std::vector<ScatteringLight> Lights;
  /// Cells that had a value that is no finite number.
  std::size_t BadCells = 0;
  double CellVolume = 1.0;
};

}

#endif

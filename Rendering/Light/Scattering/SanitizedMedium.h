// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SanitizedMedium_h
#define interlume_SanitizedMedium_h

#include "Scattering/ScatteringLight.h"
#include "Scattering/ScatteringMedium.h"

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

namespace interlume
{

/**
 * @class   SanitizedMedium
 * @brief   a medium and its lights with finite values only
 *
 * Negative and non-finite values, and the extinction and light of blocked cells, are replaced by 0.
 * Albedos are clamped to the range from 0 to 1.
 */
struct SanitizedMedium
{
  SanitizedMedium(const ScatteringMedium& medium, const std::vector<ScatteringLight>& lights);

  /// The grid with its mirrors and blocked cells. Box.Extinction and Box.Albedo are empty.
  ScatteringMedium Box;
  std::vector<float> Extinction;
  std::vector<glm::vec3> Albedo;
  /// For each light, the unscattered light in each cell.
  std::vector<std::vector<glm::vec3>> Direct;
  std::vector<ScatteringLight> Lights;
  /// Number of cells with a non-finite value.
  std::size_t BadCells = 0;
  double CellVolume = 1.0;
};

}

#endif

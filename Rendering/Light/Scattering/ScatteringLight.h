// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ScatteringLight_h
#define interlume_ScatteringLight_h

#include "Common/Error.h"
#include "Scattering/ScatteringMedium.h"

#include <vector>

#include <glm/vec3.hpp>

namespace interlume
{

/**
 * @class   ScatteringLight
 * @brief   the unscattered light of one source in the cells of a medium
 */
struct ScatteringLight
{
  /**
   * Mean of the light over each cell: the light color times the unscaled transmittance exp(-depth)
   * from the light source. Extinction times this mean is the light that the cell removes; the light
   * at the center would be inaccurate in a thick cell. Values that are negative or not finite are
   * treated as 0.
   */
  std::vector<glm::vec3> Direct;
  /// If true, the light is at Position, which may be inside the box. Otherwise, it is directional
  /// along the unit vector Direction.
  bool IsPositional = false;
  glm::dvec3 Direction{ 0.0, 0.0, 1.0 };
  glm::dvec3 Position{ 0.0 };

  /// Returns the unit direction of the light at a position, or 0 at the position of the light
  /// itself.
  glm::dvec3 GetDirection(const glm::dvec3& position) const;
  /**
   * Sets Direct to \a color times the transmittance from CellLight, for lights that only the medium
   * attenuates.
   */
  void Fill(const ScatteringMedium& medium, const glm::vec3& color);
  /// Returns an error if Direct does not have \a cells values, or if the position or direction is
  /// invalid.
  Error Check(std::size_t cells) const;
};

}

#endif

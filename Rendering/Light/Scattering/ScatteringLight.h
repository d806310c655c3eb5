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
 * @brief   the light of one source before it is scattered, in the cells of a medium
 */
struct ScatteringLight
{
  /**
   * The light's colour times its transmittance from the source, through matter by exp(-depth)
   * without any scaling: its fluence. It is the mean over the cell, not the value at the cell's
   * centre, which is off where one cell has much matter; the extinction times the mean is what the
   * cell takes from the light. What is no finite positive number counts as 0.
   */
  std::vector<glm::vec3> Direct;
  /// A light at a place shines from there, which may be in the box; any other one along Direction,
  /// of length 1.
  bool IsPositional = false;
  glm::dvec3 Direction{ 0.0, 0.0, 1.0 };
  glm::dvec3 Position{ 0.0 };

  /// Returns the direction, of length 1, in which the light goes at a place; 0 at the light's own.
  glm::dvec3 GetDirection(const glm::dvec3& place) const;
  /**
   * Sets Direct from the medium, for lights that nothing else stands before: \a color times what
   * CellLight finds.
   */
  void Fill(const ScatteringMedium& medium, const glm::vec3& color);
  /// Returns an error if the number of values is not \a cells, or the direction is not of length 1.
  Error Check(std::size_t cells) const;
};

}

#endif

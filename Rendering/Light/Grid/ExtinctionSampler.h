// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ExtinctionSampler_h
#define interlume_ExtinctionSampler_h

#include "Grid/ExtinctionGrid.h"

#include <array>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace interlume
{

/**
 * @class   ExtinctionSampler
 * @brief   evaluates the medium of a volume on the CPU in the same way as the slice shaders
 *
 * Transfer functions are interpolated linearly between the columns of their tables. Breakpoints
 * between columns are ignored.
 */
class ExtinctionSampler
{
public:
  explicit ExtinctionSampler(const ExtinctionGrid::Volume& volume);

  struct Sample
  {
    /// Extinction per unit length in unit space.
    double Extinction = 0.0;
    glm::dvec3 Albedo{ 0.0 };
    /// Transmission color.
    glm::dvec3 Transmission{ 0.0 };
  };

  /// Returns the medium at a position in unit space.
  Sample Get(const glm::dvec3& position) const;

private:
  template <typename Texel>
  glm::dvec4 Interpolate(const glm::dvec3& inTexture, double& validFraction) const;
  glm::dvec4 GetValues(const glm::dvec3& inTexture, double& validFraction) const;
  bool IsInRegion(const glm::dvec3& position, const glm::dvec3& inTexture) const;
  double GetGradient(const glm::dvec3& inTexture, const glm::dvec4& here, int component) const;

  const ExtinctionGrid::Volume& Volume;
};

}

#endif

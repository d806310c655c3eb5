// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_MatterSampler_h
#define interlume_MatterSampler_h

#include "Grid/MatterGrid.h"

#include <array>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace interlume
{

/**
 * @class   MatterSampler
 * @brief   what the slices' shader finds at a place of the volume, on the CPU
 *
 * Functions are interpolated between the columns of their tables: what bends within one column is
 * straight.
 */
class MatterSampler
{
public:
  explicit MatterSampler(const MatterGrid::Volume& volume);

  struct Sample
  {
    /// For lengths in unit space.
    double Extinction = 0.0;
    glm::dvec3 Albedo{ 0.0 };
    /// The colour of light that is let through.
    glm::dvec3 Transmission{ 0.0 };
  };

  /// Returns the matter at a place in unit space.
  Sample Get(const glm::dvec3& place) const;

private:
  template <typename Texel>
  glm::dvec4 Interpolate(const glm::dvec3& inTexture, double& share) const;
  glm::dvec4 GetValues(const glm::dvec3& inTexture, double& share) const;
  bool IsLeft(const glm::dvec3& place, const glm::dvec3& inTexture) const;
  double GetGradient(const glm::dvec3& inTexture, const glm::dvec4& here, int component) const;

  const MatterGrid::Volume& Volume;
};

}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_BoxCorners_h
#define interlume_BoxCorners_h

#include "Space/UnitVector.h"

#include <array>
#include <vector>

namespace interlume
{

class UnitSpace;

/**
 * @class   BoxCorners
 * @brief   the corners of the part of the volume that can be seen, in unit space
 */
class BoxCorners
{
public:
  /// \a box in texture coordinates.
  BoxCorners(const UnitSpace& space, const std::array<std::array<double, 2>, 3>& box);

  /// Upper along axis a where bit a of the index is set.
  const std::array<glm::dvec3, 8>& Get() const { return this->Corners; }
  glm::dvec3 GetCenter() const;
  /// Smallest and largest place along \a normal.
  std::array<double, 2> GetRange(const glm::dvec3& normal) const;
  /// Directions, of length 1, from a point through all corners but itself.
  std::vector<glm::dvec3> GetRays(const glm::dvec3& from) const;

private:
  std::array<glm::dvec3, 8> Corners;
};

}

#endif

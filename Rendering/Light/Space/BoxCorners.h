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
 * @brief   the corners of the parts of volumes that can be seen, in unit space
 */
class BoxCorners
{
public:
  /// \a box in texture coordinates.
  BoxCorners(const UnitSpace& space, const std::array<std::array<double, 2>, 3>& box);
  /// Adds the box of a further volume, in the same unit space.
  void Add(const UnitSpace& space, const std::array<std::array<double, 2>, 3>& box);

  /// Eight corners of each box; upper along axis a where bit a of the index is set.
  const std::vector<glm::dvec3>& Get() const { return this->Corners; }
  /// The middle of the box; that of the bounds of several.
  glm::dvec3 GetCenter() const;
  /// Smallest and largest place along \a normal.
  std::array<double, 2> GetRange(const glm::dvec3& normal) const;
  /// Directions, of length 1, from a point through all corners but itself.
  std::vector<glm::dvec3> GetRays(const glm::dvec3& from) const;

private:
  std::vector<glm::dvec3> Corners;
};

}

#endif

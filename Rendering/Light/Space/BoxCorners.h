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
 * @brief   corners of the boxes of volumes, in unit space
 */
class BoxCorners
{
public:
  /// \a box is in texture coordinates.
  BoxCorners(const UnitSpace& space, const std::array<std::array<double, 2>, 3>& box);
  /// Adds the box of another volume in the same unit space.
  void Add(const UnitSpace& space, const std::array<std::array<double, 2>, 3>& box);

  /// Returns eight corners per box. Bit a of a corner's index is set at the upper end of axis a.
  const std::vector<glm::dvec3>& Get() const { return this->Corners; }
  /// Returns the center of the box, or the center of the bounds of several boxes.
  glm::dvec3 GetCenter() const;
  /// Returns the smallest and largest coordinate along \a normal.
  std::array<double, 2> GetRange(const glm::dvec3& normal) const;
  /// Returns the unit vectors from a point to all corners that differ from it.
  std::vector<glm::dvec3> GetRays(const glm::dvec3& from) const;

private:
  std::vector<glm::dvec3> Corners;
};

}

#endif

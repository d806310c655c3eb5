// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_UnitVector_h
#define interlume_UnitVector_h

#include "Common/Vectors.h"

#include <array>

#include <glm/common.hpp>

namespace interlume
{

/**
 * Arithmetic of points and directions in unit space.
 */
namespace UnitVector
{
/// Rows of a matrix of homogeneous coordinates.
using Matrix = std::array<double, 16>;

/// a of length 1, or \a otherwise where a has no length.
inline glm::dvec3 Normalize(const glm::dvec3& a, const glm::dvec3& otherwise)
{
  const double length = Vectors::SafeLength(a);
  return length > 0.0 ? a / length : otherwise;
}

/// Of length 1 and perpendicular to \a a, in the direction of \a up where that is not along a.
inline glm::dvec3 Perpendicular(const glm::dvec3& a, const glm::dvec3& up)
{
  const glm::dvec3 across = up - glm::dot(up, a) * a;
  if (Vectors::SafeLength(across) > 1e-6 * Vectors::SafeLength(up))
  {
    return Normalize(across, a);
  }
  const glm::dvec3 size = glm::abs(a);
  const int axis = size[0] <= size[1] && size[0] <= size[2] ? 0 : (size[1] <= size[2] ? 1 : 2);
  glm::dvec3 other(0.0);
  other[axis] = 1.0;
  return Normalize(other - glm::dot(other, a) * a, other);
}

/// The linear part of an affine matrix.
inline glm::dvec3 TransformVector(const Matrix& m, const glm::dvec3& a)
{
  return { m[0] * a[0] + m[1] * a[1] + m[2] * a[2], m[4] * a[0] + m[5] * a[1] + m[6] * a[2],
    m[8] * a[0] + m[9] * a[1] + m[10] * a[2] };
}

inline glm::dvec3 TransformPoint(const Matrix& m, const glm::dvec3& a)
{
  return TransformVector(m, a) + glm::dvec3(m[3], m[7], m[11]);
}
}

}

#endif

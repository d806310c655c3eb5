// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_UnitVector_h
#define interlume_UnitVector_h

#include "Common/Vectors.h"

#include <glm/common.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

namespace interlume
{

/**
 * Arithmetic with points and directions in unit space, and with homogeneous matrices.
 */
namespace UnitVector
{
/// Converts a row-major array, such as the data of a vtkMatrix4x4.
inline glm::dmat4 FromRows(const double rows[16])
{
  return glm::transpose(glm::make_mat4(rows));
}

/// Returns the first three elements of a row.
inline glm::dvec3 GetRow(const glm::dmat4& m, int row)
{
  return glm::dvec3(glm::row(m, row));
}

/// Returns \a a scaled to length 1, or \a otherwise if the length of \a a is 0.
inline glm::dvec3 Normalize(const glm::dvec3& a, const glm::dvec3& otherwise)
{
  const double length = Vectors::SafeLength(a);
  return length > 0.0 ? a / length : otherwise;
}

/// Returns a unit vector perpendicular to \a a, as close to \a up as possible.
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

/// Applies the linear part of an affine matrix.
inline glm::dvec3 TransformVector(const glm::dmat4& m, const glm::dvec3& a)
{
  return glm::dmat3(m) * a;
}

inline glm::dvec3 TransformPoint(const glm::dmat4& m, const glm::dvec3& a)
{
  return TransformVector(m, a) + glm::dvec3(m[3]);
}
}

}

#endif

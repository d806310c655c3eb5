#ifndef interlume_UnitVector_h
#define interlume_UnitVector_h

#include "vtkMath.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace interlume
{

/**
 * Arithmetic of points and directions in unit space.
 */
namespace UnitVector
{
using Vector = std::array<double, 3>;
/// Rows of a matrix of homogeneous coordinates.
using Matrix = std::array<double, 16>;

inline double Dot(const Vector& a, const Vector& b)
{
  return vtkMath::Dot(a.data(), b.data());
}

/// s a + t b
inline Vector Combine(double s, const Vector& a, double t, const Vector& b)
{
  return { { s * a[0] + t * b[0], s * a[1] + t * b[1], s * a[2] + t * b[2] } };
}

inline Vector Scale(double s, const Vector& a)
{
  return Combine(s, a, 0.0, a);
}

inline Vector Cross(const Vector& a, const Vector& b)
{
  Vector c;
  vtkMath::Cross(a.data(), b.data(), c.data());
  return c;
}

/// Of any size, without overflow and underflow; NaN if a component is not finite.
inline double Length(const Vector& a)
{
  const double size = std::max({ std::abs(a[0]), std::abs(a[1]), std::abs(a[2]) });
  if (!(size > 0.0))
  {
    return a[0] + a[1] + a[2];
  }
  const Vector b{ { a[0] / size, a[1] / size, a[2] / size } };
  return size * std::sqrt(Dot(b, b));
}

/// a of length 1, or \a otherwise where a has no length.
inline Vector Normalize(const Vector& a, const Vector& otherwise)
{
  const double length = Length(a);
  return length > 0.0 ? Vector{ { a[0] / length, a[1] / length, a[2] / length } } : otherwise;
}

/// Of length 1 and perpendicular to \a a, in the direction of \a up where that is not along a.
inline Vector Perpendicular(const Vector& a, const Vector& up)
{
  const Vector across = Combine(1.0, up, -Dot(up, a), a);
  if (Length(across) > 1e-6 * Length(up))
  {
    return Normalize(across, a);
  }
  const auto size = [&](int i) { return std::abs(a[static_cast<std::size_t>(i)]); };
  const int axis = size(0) <= size(1) && size(0) <= size(2) ? 0 : (size(1) <= size(2) ? 1 : 2);
  Vector other{ { 0.0, 0.0, 0.0 } };
  other[static_cast<std::size_t>(axis)] = 1.0;
  return Normalize(Combine(1.0, other, -Dot(other, a), a), other);
}

/// The linear part of an affine matrix.
inline Vector TransformVector(const Matrix& m, const Vector& a)
{
  return { { m[0] * a[0] + m[1] * a[1] + m[2] * a[2], m[4] * a[0] + m[5] * a[1] + m[6] * a[2],
    m[8] * a[0] + m[9] * a[1] + m[10] * a[2] } };
}

inline Vector TransformPoint(const Matrix& m, const Vector& a)
{
  return Combine(1.0, TransformVector(m, a), 1.0, { { m[3], m[7], m[11] } });
}
}

}

#endif

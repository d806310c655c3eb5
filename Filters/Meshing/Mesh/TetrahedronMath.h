#ifndef interlume_TetrahedronMath_h
#define interlume_TetrahedronMath_h

#include <array>

namespace interlume
{

/**
 * Geometry of one tetrahedron a, b, c, d, positive when (b-a) . (c-a) x (d-a) is.
 */
namespace TetrahedronMath
{

using Vector = std::array<double, 3>;

inline Vector Difference(const double* a, const double* b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}

inline double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vector Cross(const Vector& a, const Vector& b)
{
  return { { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] } };
}

/// Six times the signed volume.
inline double Determinant(const double* a, const double* b, const double* c, const double* d)
{
  return Dot(Difference(b, a), Cross(Difference(c, a), Difference(d, a)));
}

/// The sine of the solid angle at a, a measure of shape without a unit: at most 1 in magnitude.
double PolarSine(const double* a, const double* b, const double* c, const double* d);

/// Radius of the circumscribed sphere over the shortest edge; at least sqrt(6)/4 = 0.612.
double RadiusEdgeRatio(const double* a, const double* b, const double* c, const double* d);

}

}

#endif

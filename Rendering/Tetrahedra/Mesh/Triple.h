#ifndef interlume_Triple_h
#define interlume_Triple_h

#include <algorithm>
#include <array>
#include <cmath>

namespace interlume
{

/// A point or vector of space.
using Triple = std::array<double, 3>;

/**
 * Arithmetic of points and vectors.
 */
namespace TripleMath
{
inline Triple Get(const double* p)
{
  return { { p[0], p[1], p[2] } };
}
inline Triple Subtract(const Triple& a, const Triple& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}
/// a + s b
inline Triple Add(const Triple& a, double s, const Triple& b)
{
  return { { a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2] } };
}
inline double Dot(const Triple& a, const Triple& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Triple Cross(const Triple& a, const Triple& b)
{
  return { { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] } };
}
/// The greatest component in amount.
inline double GetSize(const Triple& a)
{
  return std::max(std::abs(a[0]), std::max(std::abs(a[1]), std::abs(a[2])));
}
}

}

#endif

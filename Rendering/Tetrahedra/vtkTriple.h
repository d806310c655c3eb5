#ifndef vtkTriple_h
#define vtkTriple_h

#include <algorithm>
#include <array>
#include <cmath>

/// A point or vector of space.
using vtkTriple = std::array<double, 3>;

/**
 * Arithmetic of points and vectors.
 */
namespace vtkTripleMath
{
inline vtkTriple Get(const double* p)
{
  return { { p[0], p[1], p[2] } };
}
inline vtkTriple Subtract(const vtkTriple& a, const vtkTriple& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}
/// a + s b
inline vtkTriple Add(const vtkTriple& a, double s, const vtkTriple& b)
{
  return { { a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2] } };
}
inline double Dot(const vtkTriple& a, const vtkTriple& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline vtkTriple Cross(const vtkTriple& a, const vtkTriple& b)
{
  return { { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] } };
}
/// The greatest component in amount.
inline double GetSize(const vtkTriple& a)
{
  return std::max(std::abs(a[0]), std::max(std::abs(a[1]), std::abs(a[2])));
}
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_IntegerAlgebra_h
#define interlume_IntegerAlgebra_h

#include "Hulls/ConvexHull.h"

#include <algorithm>
#include <vector>

namespace interlume
{

/**
 * Exact integer linear algebra for convex hulls, isosurface patches and symmetries.
 */
namespace IntegerAlgebra
{
using Point = ConvexHull::Point;
using Normal = ConvexHull::Normal;
constexpr int MaximumDimension = Polytope::MaximumDimension;

/// Computes the determinant of the n x n matrix with the rows \a m, restricted to the given
/// columns.
inline std::int64_t Determinant(const Normal* m, const int* columns, int n)
{
  if (n == 1)
  {
    return m[0][columns[0]];
  }
  if (n == 2)
  {
    return m[0][columns[0]] * m[1][columns[1]] - m[0][columns[1]] * m[1][columns[0]];
  }
  std::int64_t sum = 0;
  int rest[MaximumDimension];
  for (int skip = 0; skip < n; ++skip)
  {
    if (m[0][columns[skip]] == 0)
    {
      continue;
    }
    std::copy(columns, columns + skip, rest);
    std::copy(columns + skip + 1, columns + n, rest + skip);
    const std::int64_t minor = m[0][columns[skip]] * Determinant(m + 1, rest, n - 1);
    sum += (skip & 1) ? -minor : minor;
  }
  return sum;
}

inline std::int64_t Dot(int dimension, const Normal& n, const Point& p)
{
  std::int64_t sum = 0;
  for (int axis = 0; axis < dimension; ++axis)
  {
    sum += n[axis] * p[axis];
  }
  return sum;
}

inline Normal Difference(const Point& a, const Point& b)
{
  Normal d{};
  for (int axis = 0; axis < MaximumDimension; ++axis)
  {
    d[axis] = a[axis] - b[axis];
  }
  return d;
}

/// Computes the generalized cross product: a vector orthogonal to the first dimension - 1 rows. The
/// determinant of these rows followed by the vector is positive.
inline Normal CrossProduct(int dimension, const std::array<Normal, MaximumDimension - 1>& rows)
{
  Normal normal{};
  int columns[MaximumDimension];
  for (int axis = 0; axis < dimension; ++axis)
  {
    for (int i = 0, n = 0; i < dimension; ++i)
    {
      if (i != axis)
      {
        columns[n++] = i;
      }
    }
    const std::int64_t cofactor = Determinant(rows.data(), columns, dimension - 1);
    normal[axis] = ((dimension - 1 + axis) & 1) ? -cofactor : cofactor;
  }
  return normal;
}

/// Affine span of points that are inserted one by one. The rows are the differences of independent
/// points from the first point. Their minor in the pivot columns is nonzero. Another point is
/// outside the span if its row and some additional column extend this minor to a nonzero one.
/// Minors of coordinates up to MaximumCoordinate fit in 64 bits.
class Span
{
public:
  explicit Span(int dimension)
    : Dimension(dimension)
  {
  }

  /// Adds a point. Returns whether it was outside the span of the previous points.
  bool Insert(const Point& p)
  {
    if (this->IsEmpty)
    {
      this->Origin = p;
      this->IsEmpty = false;
      return true;
    }
    const std::size_t rank = this->Pivots.size();
    if (static_cast<int>(rank) == this->Dimension)
    {
      return false;
    }
    this->Rows[rank] = Difference(p, this->Origin);
    this->Pivots.push_back(0);
    for (int axis = 0; axis < this->Dimension; ++axis)
    {
      this->Pivots[rank] = axis;
      if (std::find(this->Pivots.begin(), this->Pivots.end() - 1, axis) == this->Pivots.end() - 1 &&
        Determinant(this->Rows.data(), this->Pivots.data(), static_cast<int>(rank) + 1) != 0)
      {
        return true;
      }
    }
    this->Pivots.pop_back();
    return false;
  }

  const std::vector<int>& GetPivots() const { return this->Pivots; }

private:
  int Dimension;
  bool IsEmpty = true;
  Point Origin{};
  std::array<Normal, MaximumDimension> Rows{};
  std::vector<int> Pivots;
};
}

}

#endif

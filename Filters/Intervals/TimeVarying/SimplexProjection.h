// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SimplexProjection_h
#define interlume_SimplexProjection_h

#include "TimeVarying/SimplexSigns.h"

#include <array>
#include <cstdint>

namespace interlume
{

/**
 * @class   SimplexProjection
 * @brief   projection of a 4-simplex along its fourth coordinate, as a set of tetrahedra
 *
 * Five points in 3D satisfy one affine dependency, sum lambda_i x_i = 0 with sum lambda_i = 0. The
 * points with positive lambda_i span one face of the simplex, the points with negative lambda_i
 * another. Their projections intersect in one point (Radon's theorem), the thick point. There the
 * simplex has its maximum thickness |sum lambda_i t_i| / L, where L is the sum of the positive
 * lambda_i.
 *
 * Each tetrahedron consists of the thick point and the three points that remain after removing one
 * positive and one negative point. The projection is the union of these tetrahedra. The thickness
 * is linear in each of them and zero at the three points. The numbers of positive, negative and
 * zero lambda_i define the classes of C. Zhang, dissertation, Ohio State 2006, section 3.5.2:
 * (3,2,0) is 1, (4,1,0) is 2, (2,2,1) is 3a, (3,1,1) is 3b, (2,1,2) is 4, (1,1,3) is 5.
 *
 * lambda_i is proportional to the volume of the tetrahedron without point i. It is set to zero if
 * its absolute value is below 2^-44 L f, where f is the thickness relative to the time extent of
 * the simplex. This bounds the relative error of volume times thickness by 1e-12. If double
 * precision would lose too many digits, long double is used.
 */
class SimplexProjection
{
public:
  /// The coordinates x, y and z of a point, and its coordinate t along the projection direction.
  using Point = std::array<double, 4>;

  static constexpr int NumberOfPoints = SimplexSigns::NumberOfPoints;
  using Corners = std::array<Point, NumberOfPoints>;

  SimplexProjection() = default;

  /// Projects a simplex. Set bit i of \a flat if the points other than point i are known to be
  /// coplanar after projection.
  SimplexProjection(const Corners& points, unsigned flat);

  /// Projects several simplices. The result does not depend on which simplices are projected
  /// together.
  static void Project(
    const Corners* points, const std::uint8_t* flats, int number, SimplexProjection* projections);

  /// Returns true if the simplex is degenerate, that is, has no volume in space or no thickness. A
  /// degenerate simplex has no tetrahedra.
  bool IsFlat() const { return this->Thickness == 0.0; }

  /// Returns true if the determinant of (p1 - p0, p2 - p0, p3 - p0, p4 - p0) is negative.
  bool IsInverted() const { return this->Signs.IsInverted(); }

  /// Returns 0 ... 5 for the classes 1, 2, 3a, 3b, 4, 5. Degenerate simplices have no class.
  int GetClass() const { return this->Signs.GetDecomposition().Class; }

  int GetNumberOfTetrahedra() const { return this->Signs.GetDecomposition().NumberOfTetrahedra; }

  /// Returns the extent of the simplex along the fourth coordinate at the thick point.
  double GetThickness() const { return this->Thickness; }

  /// Returns the weights of the points. The weighted sum of the values at the points is the mean
  /// value over the thickness at the thick point.
  const std::array<double, NumberOfPoints>& GetWeights() const { return this->Weights; }

  /// Returns the signs of all lambda_i. They determine the tetrahedra.
  const SimplexSigns& GetSigns() const { return this->Signs; }

  /// Computes the position of the thick point from the points of the simplex. If it coincides with
  /// one of them, the result is exact.
  void GetThickPoint(const Corners& points, double x[3]) const
  {
    // The thick point lies on both the positive and the negative face. The face with fewer points
    // causes fewer rounding errors, and none if it is a single point.
    const SimplexSigns::Cut& cut = this->Signs.GetDecomposition();
    x[0] = x[1] = x[2] = 0.0;
    for (int m = 0; m < cut.NumberOfMeanPoints; ++m)
    {
      const int i = cut.MeanPoints[m];
      for (int axis = 0; axis < 3; ++axis)
      {
        x[axis] +=
          cut.NumberOfMeanPoints == 1 ? points[i][axis] : 2.0 * this->Weights[i] * points[i][axis];
      }
    }
  }

private:
  // Projects a simplex for which double precision would lose too many digits.
  void ProjectExtended(const Corners& points, unsigned flat);

  std::array<double, NumberOfPoints> Weights{};
  double Thickness = 0.0;
  SimplexSigns Signs;
};

}

#endif

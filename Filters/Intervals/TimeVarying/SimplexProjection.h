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
 * @brief   a 4-simplex projected along its fourth coordinate, and cut into tetrahedra
 *
 * Five points in space have one affine dependency, sum lambda_i x_i = 0, sum lambda_i = 0. Its
 * positive and its negative part are two faces of the simplex that meet in one point, the thick
 * point (Radon). There the simplex is thickest: by |sum lambda_i t_i| / L, where L is the sum of
 * the positive lambda_i. The projection is the union of the tetrahedra of the thick point with the
 * three points that are left when one of the positive and one of the negative points is taken away,
 * and the thickness is linear in each, zero at the three. The numbers of positive, negative and
 * zero lambda_i are the classes of C. Zhang, dissertation, Ohio State 2006, section 3.5.2: (3,2,0)
 * is 1, (4,1,0) is 2, (2,2,1) is 3a, (3,1,1) is 3b, (2,1,2) is 4, (1,1,3) is 5.
 *
 * lambda_i is the volume of the tetrahedron without point i. One that is below 2^-44 of L, or of L
 * times the share that the thickness has of the simplex's extent in time, counts as zero: leaving
 * out a part of that size keeps the sum of volume times thickness to 1e-12. Where double precision
 * would lose too many digits, long double is used.
 */
class SimplexProjection
{
public:
  /// A point as x, y, z and the coordinate that is projected along.
  using Point = std::array<double, 4>;

  static constexpr int NumberOfPoints = SimplexSigns::NumberOfPoints;
  using Corners = std::array<Point, NumberOfPoints>;

  SimplexProjection() = default;

  /// Projects a simplex. Bit i of \a flat is set where points other than i are known to lie in a
  /// plane.
  SimplexProjection(const Corners& points, unsigned flat);

  ///@{
  /**
   * Projects several simplices, each with the bytes that it has alone: for AVX2 where the machine
   * has it, and without on any machine.
   */
  static void Project(
    const Corners* points, const std::uint8_t* flats, int number, SimplexProjection* projections);
  static void ProjectPlainly(
    const Corners* points, const std::uint8_t* flats, int number, SimplexProjection* projections);
  ///@}

  /// Returns whether it has no volume in space or no thickness; then it has no tetrahedra.
  bool IsFlat() const { return this->Thickness == 0.0; }

  /// Returns whether (p1 - p0, p2 - p0, p3 - p0, p4 - p0) have a negative determinant.
  bool IsInverted() const { return this->Signs.IsInverted(); }

  /// Returns 0 ... 5 for the classes 1, 2, 3a, 3b, 4, 5. A flat simplex has no class.
  int GetClass() const { return this->Signs.GetCut().Class; }

  int GetNumberOfTetrahedra() const { return this->Signs.GetCut().NumberOfTetrahedra; }

  /// Returns how long the simplex lasts at its thick point.
  double GetThickness() const { return this->Thickness; }

  /// Returns the weights of the points: the mean of a value over the thickness at the thick point
  /// is the sum of the weights times the values at the points.
  const std::array<double, NumberOfPoints>& GetWeights() const { return this->Weights; }

  /// Returns the sign of each lambda, from which its tetrahedra follow.
  const SimplexSigns& GetSigns() const { return this->Signs; }

  /// Computes the place of the thick point from those of the points: exactly one of them where it
  /// is one.
  void GetThickPoint(const Corners& points, double x[3]) const
  {
    // Both faces meet at the thick point: the smaller one gives fewer roundings, and its own point
    // where it is a single one.
    const SimplexSigns::Cut& cut = this->Signs.GetCut();
    x[0] = x[1] = x[2] = 0.0;
    for (int m = 0; m < cut.NumberOfMeant; ++m)
    {
      const int i = cut.Meant[m];
      for (int axis = 0; axis < 3; ++axis)
      {
        x[axis] +=
          cut.NumberOfMeant == 1 ? points[i][axis] : 2.0 * this->Weights[i] * points[i][axis];
      }
    }
  }

private:
  // Projects a simplex where double precision would lose too many digits.
  void ProjectExtended(const Corners& points, unsigned flat);
  template <typename ProjectFourOnes>
  static void ProjectEach(const Corners* points, const std::uint8_t* flats, int number,
    SimplexProjection* projections, ProjectFourOnes&& projectFour);

  std::array<double, NumberOfPoints> Weights{};
  double Thickness = 0.0;
  SimplexSigns Signs;
};

}

#endif

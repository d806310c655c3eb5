// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceFlow_h
#define ReferenceFlow_h

#include <array>
#include <functional>

namespace reference
{

using Place = std::array<double, 3>;

/**
 * @class   Flow
 * @brief   a vector field by formula, and its gradient dv[i]/dx[j] at [3 i + j]
 */
struct Flow
{
  std::function<void(const double x[3], double v[3])> Velocity;
  std::function<void(const double x[3], double gradient[9])> Gradient;
  /// For means along paths.
  std::function<double(int array, const double x[3])> Array;

  /// v = velocity.
  static Flow Uniform(const Place& velocity);
  /// v = matrix (x - center), the matrix by rows.
  static Flow Linear(const std::array<double, 9>& matrix, const Place& center = {});
  /// Around z, by an angle of \a rate per unit of time.
  static Flow Rotation(double rate);
  /// Potential flow of speed 1 along x at infinity, round the sphere of radius 1 at the origin.
  static Flow RoundSphere();
  /// Of Arnold, Beltrami and Childress: chaotic, its own curl.
  static Flow Beltrami(double a, double b, double c);
  /// v = (tanh(y / thickness), 0, 0) + drift.
  static Flow ShearLayer(double thickness, const Place& drift);

  /// The same, \a factor times as fast.
  Flow Times(double factor) const;

  /// Where the streamline from \a start is after \a time, to 1e-13, by a method of order 8(7).
  Place Follow(const Place& start, double time) const;
};

}

#endif

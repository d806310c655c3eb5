// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceFlow_h
#define ReferenceFlow_h

#include <array>
#include <functional>

namespace reference
{

using Position = std::array<double, 3>;

/**
 * @struct  Flow
 * @brief   vector field defined by a formula, with its gradient dv[i]/dx[j] at index 3 i + j
 */
struct Flow
{
  std::function<void(const double x[3], double v[3])> Velocity;
  std::function<void(const double x[3], double gradient[9])> Gradient;
  /// Returns the value at x of the array with the given index, for means along streamlines.
  std::function<double(int array, const double x[3])> Array;

  /// Returns v = velocity.
  static Flow Uniform(const Position& velocity);
  /// Returns v = matrix (x - center), with the matrix in row-major order.
  static Flow Linear(const std::array<double, 9>& matrix, const Position& center = {});
  /// Returns the flow that rotates about the z-axis with angular velocity \a rate.
  static Flow Rotation(double rate);
  /// Returns the potential flow around the unit sphere at the origin. The speed at infinity is 1
  /// along x.
  static Flow RoundSphere();
  /// Returns an Arnold-Beltrami-Childress flow, which is chaotic and equal to its curl.
  static Flow Beltrami(double a, double b, double c);
  /// Returns v = (tanh(y / thickness), 0, 0) + drift.
  static Flow ShearLayer(double thickness, const Position& drift);

  /// Returns the flow with its velocity multiplied by \a factor.
  Flow Times(double factor) const;

  /// Returns the position on the streamline from \a start after \a time, with an error of 1e-13, by
  /// a Runge-Kutta method of order 8(7).
  Position Follow(const Position& start, double time) const;
};

}

#endif

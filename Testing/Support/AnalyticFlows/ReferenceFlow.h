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
 * @brief   vector field given by formulas for the velocity v and its gradient
 *
 * The gradient has dv[i]/dx[j] at index 3 i + j.
 */
struct Flow
{
  std::function<void(const double x[3], double v[3])> Velocity;
  std::function<void(const double x[3], double gradient[9])> Gradient;
  /// Returns the value at x of the point array with index \a array, for tests of means along
  /// streamlines.
  std::function<double(int array, const double x[3])> Array;

  static Flow Uniform(const Position& velocity);
  /// Returns the flow v = matrix (x - center). The matrix is in row-major order.
  static Flow Linear(const std::array<double, 9>& matrix, const Position& center = {});
  /// Returns the rigid rotation about the z-axis with angular velocity \a rate.
  static Flow Rotation(double rate);
  /// Returns the potential flow around the unit sphere at the origin. The velocity at infinity is
  /// (1, 0, 0).
  static Flow PotentialAroundSphere();
  /// Returns an Arnold-Beltrami-Childress flow, which is chaotic and equal to its curl.
  static Flow Beltrami(double a, double b, double c);
  /// Returns the flow v = (tanh(y / thickness), 0, 0) + drift.
  static Flow ShearLayer(double thickness, const Position& drift);

  /// Returns this flow with its velocity multiplied by \a factor.
  Flow Times(double factor) const;

  /// Returns the position after \a time on the streamline that starts at \a start. Uses a
  /// Runge-Kutta-Fehlberg 7(8) method with a tolerance of 1e-13.
  Position Follow(const Position& start, double time) const;
};

}

#endif

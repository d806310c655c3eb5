// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PhaseFunction_h
#define interlume_PhaseFunction_h

#include "Common/Error.h"

#include <vector>

namespace interlume
{

/**
 * @class   PhaseFunction
 * @brief   the angular distribution of scattered light
 *
 * The phase function p, in 1/steradian, depends on the cosine of the angle between the directions
 * of light before and after scattering. Its integral over the sphere is 1: 2 pi times its integral
 * over the cosine from -1 to 1. By default it is isotropic: p = 1 / (4 pi).
 */
class PhaseFunction
{
public:
  void SetIsotropic();
  /**
   * Sets the Henyey-Greenstein function p = (1 - g^2) / (4 pi (1 + g^2 - 2 g cosine)^1.5) with the
   * mean cosine \a g, between -1 and 1 exclusive. For other values, returns an error and leaves the
   * function unchanged.
   */
  Error SetHenyeyGreenstein(double g);
  /**
   * Interpolates linearly between at least 2 \a values at equally spaced cosines, from -1
   * (backscattered light) to 1 (forward-scattered light), and normalizes them. Returns an error if
   * a value is negative or not finite, or if all values are 0.
   */
  Error SetTable(const std::vector<double>& values);

  /// Returns p at a cosine, which is clamped to the range from -1 to 1.
  double Value(double cosine) const;
  /// Returns the integral over the sphere of p times the Legendre polynomial of degree \a n: 1 for
  /// n = 0, the mean cosine for n = 1, g^n for Henyey-Greenstein.
  double Moment(int n) const;
  /// Returns the fraction of light scattered by less than a right angle.
  double ForwardFraction() const;
  /**
   * Returns the variance that one scattering event adds to the angle of forward-scattered light,
   * along each of two transverse axes: half the mean of sin^2 of the angle over forward directions.
   * It is in squared radians for small angles, and 1/3 for an isotropic function.
   */
  double ForwardVariance() const;

  bool operator==(const PhaseFunction& other) const;
  bool operator!=(const PhaseFunction& other) const { return !(*this == other); }

private:
  /// Returns the integral of p times a function of the cosine, over cosines from \a lower to 1.
  template <typename Function>
  double Integrate(double lower, Function&& function) const;

  /// Empty for the Henyey-Greenstein function.
  std::vector<double> Table;
  double Anisotropy = 0.0;
};

}

#endif

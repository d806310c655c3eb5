// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PhaseFunction_h
#define interlume_PhaseFunction_h

#include "Common/Error.h"

#include <vector>

namespace interlume
{

/**
 * @class   PhaseFunction
 * @brief   the share of scattered light that goes on at an angle to where it came from
 *
 * A function p of the cosine between the direction of light before and after it is scattered, in
 * 1/steradian: 2 pi times its integral over the cosine from -1 to 1 is 1. It is isotropic unless
 * set: p = 1 / (4 pi).
 */
class PhaseFunction
{
public:
  void SetIsotropic();
  /**
   * Henyey and Greenstein's p = (1 - g^2) / (4 pi (1 + g^2 - 2 g cosine)^1.5) with the mean cosine
   * g, of which \a g is the value; between -1 and 1, these excluded. Returns an error
   * for other values; the function does not change then.
   */
  Error SetHenyeyGreenstein(double g);
  /**
   * Linear between \a values at cosines that are evenly spaced from -1 (light that goes back) to 1
   * (light that goes on), 2 at least, scaled so that it is normalised. Returns an error if a
   * value is negative or not finite, or all are 0.
   */
  Error SetTable(const std::vector<double>& values);

  /// Returns p at a cosine, which is clamped to -1 to 1.
  double Value(double cosine) const;
  /// Returns the integral of p times the Legendre polynomial of degree \a n over the sphere: 1 for
  /// n = 0, the mean cosine for n = 1, g^n by Henyey and Greenstein.
  double Moment(int n) const;
  /// Returns the share of light that is scattered by less than a right angle.
  double ForwardShare() const;
  /**
   * Returns the variance of angle to each of two axes across the light that one scattering adds to
   * the light that goes on forwards: half of the mean of sin^2 of the angle over the forward
   * directions, in square radians where angles are small, and 1/3 for an isotropic function.
   */
  double ForwardVariance() const;

  bool operator==(const PhaseFunction& other) const;
  bool operator!=(const PhaseFunction& other) const { return !(*this == other); }

private:
  /// The integral of p times a function of the cosine from \a lower to 1 over the sphere's part.
  template <typename Function>
  double Integrate(double lower, Function&& function) const;

  /// Empty for Henyey and Greenstein's function.
  std::vector<double> Table;
  double Anisotropy = 0.0;
};

}

#endif

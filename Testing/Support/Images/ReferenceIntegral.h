// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceIntegral_h
#define ReferenceIntegral_h

#include <array> // for colors

namespace reference
{

/**
 * A part of a view ray along which extinction, weight and color are linear.
 */
struct LinearPart
{
  double Length = 0.0;
  /// Values at both ends: extinction per unit length, weight (temporal extent) and color.
  std::array<double, 2> Extinction{};
  std::array<double, 2> Weight{ { 1.0, 1.0 } };
  std::array<std::array<double, 3>, 2> Color{};
};

/**
 * Radiance and optical depth of a part of a view ray.
 */
struct Light
{
  /// Integral of extinction times weight along the part.
  double Depth = 0.0;
  /// Integral of color times extinction times weight, without absorption.
  std::array<double, 3> Emitted{};
  /// The same integral, attenuated by the absorption between the front end of the part and each
  /// point of emission.
  std::array<double, 3> Seen{};

  /// Returns 1 - exp(-Depth).
  double GetAlpha() const;
  /// Adds the light of a part behind this part, attenuated by this part.
  void AddBehind(const Light& back);
};

/**
 * Integrates with the eight-point Gauss-Legendre rule. Intervals are halved until the optical depth
 * of each is below 1/2 and its integral agrees with the sum over its halves to within 1e-12. No
 * closed form of the integral is used. Optical depths from 0 to 1e12 are supported.
 */
Light Integrate(const LinearPart& part);

}

#endif

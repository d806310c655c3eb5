// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceIntegral_h
#define ReferenceIntegral_h

#include <array> // for colours

namespace reference
{

/**
 * A part of a line of sight along which extinction, weight and colour are linear each.
 */
struct StraightPart
{
  double Length = 0.0;
  /// At both ends; extinction per unit of length, weight (the extent in time), colour.
  std::array<double, 2> Extinction{};
  std::array<double, 2> Weight{ { 1.0, 1.0 } };
  std::array<std::array<double, 3>, 2> Color{};
};

/**
 * What comes out of a part of a line of sight.
 */
struct Light
{
  /// The integral of extinction times weight.
  double Depth = 0.0;
  /// The integral of colour times extinction times weight: as above, seen through nothing.
  std::array<double, 3> Emitted{};
  /// The same, seen through what lies in front of it within the part.
  std::array<double, 3> Seen{};

  /// 1 - exp(-Depth)
  double GetAlpha() const;
  /// Adds what comes out of the part behind.
  void AddBehind(const Light& back);
};

/**
 * Integrates by the rule of Gauss and Legendre with eight points, on intervals that are halved
 * until each is of an optical depth below 1/2 and agrees with its halves to 1e-12: no closed form
 * of the integral is used. Depths from 0 to 1e12.
 */
Light Integrate(const StraightPart& part);

}

#endif

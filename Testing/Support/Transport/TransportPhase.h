// SPDX-License-Identifier: BSD-3-Clause
#ifndef TransportPhase_h
#define TransportPhase_h

#include <glm/vec3.hpp>

#include <vector>

namespace reference
{

class TransportRandom;

/**
 * @class   TransportPhase
 * @brief   how light is turned where it is scattered
 *
 * p(c) per steradian, c the cosine of the angle by which light turns, 1 straight on; its integral
 * over the sphere is 1. Isotropic; Henyey and Greenstein's (1 - g^2) / (4 pi (1 + g^2 - 2 g
 * c)^(3/2)); or a table, straight between its nodes.
 */
class TransportPhase
{
public:
  /// Isotropic.
  TransportPhase() = default;
  /// \a g between -1 and 1, neither of which it is.
  static TransportPhase HenyeyGreenstein(double g);
  /// Values of any scale, not negative, at cosines that rise from -1 to 1. std::invalid_argument
  /// for others.
  static TransportPhase Table(
    const std::vector<double>& cosines, const std::vector<double>& values);

  /// Returns p at a cosine, per steradian.
  double GetValue(double cosine) const;
  /// Returns the mean of the cosine, g.
  double GetMeanCosine() const { return this->MeanCosine; }
  /// Returns a direction into which light that goes along \a direction is scattered.
  glm::dvec3 Scatter(const glm::dvec3& direction, TransportRandom& random) const;

private:
  double SampleCosine(double share) const;
  double SampleTable(double share) const;

  double MeanCosine = 0.0;
  /// The table's nodes, p at them times 2 pi, and the share of light up to them; empty for none.
  std::vector<double> Cosines;
  std::vector<double> Values;
  std::vector<double> Shares;
};

}

#endif

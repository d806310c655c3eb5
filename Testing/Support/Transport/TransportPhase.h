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
 * @brief   phase function p(c), where c is the cosine of the scattering angle
 *
 * c is 1 for forward scattering. p is per steradian, and its integral over the sphere is 1. It is
 * isotropic, the Henyey-Greenstein function (1 - g^2) / (4 pi (1 + g^2 - 2 g c)^(3/2)), or a
 * piecewise linear table.
 */
class TransportPhase
{
public:
  /// Creates an isotropic phase function.
  TransportPhase() = default;
  /// Returns a Henyey-Greenstein function. \a g must be between -1 and 1, exclusive.
  static TransportPhase HenyeyGreenstein(double g);
  /// Returns the normalized function with the given nonnegative values at the given cosines, which
  /// rise from -1 to 1. Throws std::invalid_argument for other input.
  static TransportPhase Table(
    const std::vector<double>& cosines, const std::vector<double>& values);

  /// Returns p(cosine).
  double GetValue(double cosine) const;
  /// Returns the mean cosine g.
  double GetMeanCosine() const { return this->MeanCosine; }
  /// Returns the random direction in which light that travels along \a direction is scattered.
  glm::dvec3 Scatter(const glm::dvec3& direction, TransportRandom& random) const;

private:
  double SampleCosine(double cumulative) const;
  double SampleTable(double cumulative) const;

  double MeanCosine = 0.0;
  /// The cosines, p times 2 pi, and the cumulative distribution at the nodes of the table. Empty if
  /// there is no table.
  std::vector<double> Cosines;
  std::vector<double> Values;
  std::vector<double> Cumulative;
};

}

#endif

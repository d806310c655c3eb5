// SPDX-License-Identifier: BSD-3-Clause
#ifndef SeenLight_h
#define SeenLight_h

#include "Scattering/ScatteringSolver.h"

#include <vector>

#include <glm/vec3.hpp>

namespace reference
{

/**
 * @class   RadianceSampler
 * @brief   radiance that leaves a box of medium, sampled by random view rays
 *
 * The result corresponds to rendering with very thin slices. The single scattering is computed from
 * the transmittance along a ray to each light. The solver's field is interpolated between cell
 * centers. Only the first color channel is computed, with lights of color 1. Mirrors are not
 * supported.
 */
class RadianceSampler
{
public:
  RadianceSampler(const interlume::ScatteringMedium& medium,
    const std::vector<interlume::ScatteringLight>& lights, double g);

  /// Incoming and outgoing energy as in ScatteringReport, and the standard error of their
  /// difference.
  struct Energy
  {
    double Incoming = 0.0;
    double Seen = 0.0;
    double Error = 0.0;
  };
  /// Returns the light that the medium extinguishes, and the light that leaves it in all
  /// directions, for each field. For a null field, only single scattering is included.
  std::vector<Energy> GetEnergy(
    const std::vector<const interlume::ScatteredLight*>& fields, int rays, unsigned seed) const;

private:
  class Walk;

  double SampleIncomingLight(std::size_t light, class Random& random) const;
  /// Computes the radiance at \a position on the boundary along the view ray \a direction, for each
  /// field.
  void TraceRay(const glm::dvec3& position, const glm::dvec3& direction,
    const std::vector<const interlume::ScatteredLight*>& fields, class Random& random,
    std::vector<double>& seen, double& transmittance) const;
  double GetSource(const glm::dvec3& position, const glm::dvec3& out,
    const interlume::ScatteredLight* field, const std::vector<double>& phases,
    const std::vector<double>& lights) const;
  double GetTransmittance(std::size_t light, const glm::dvec3& position) const;
  double GetPhase(double cosine) const;
  glm::dvec3 Scatter(const glm::dvec3& direction, class Random& random) const;
  /// Returns a random position on the faces through which rays along \a direction enter. Sets \a
  /// area to the projected area of these faces.
  glm::dvec3 SampleBoundary(const glm::dvec3& direction, class Random& random, double& area) const;

  const interlume::ScatteringMedium& Medium;
  const std::vector<interlume::ScatteringLight>& Lights;
  double Anisotropy;
};

}

#endif

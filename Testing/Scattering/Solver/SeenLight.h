// SPDX-License-Identifier: BSD-3-Clause
#ifndef SeenLight_h
#define SeenLight_h

#include "Scattering/ScatteringSolver.h"

#include <vector>

#include <glm/vec3.hpp>

namespace reference
{

/**
 * @class   SeenLight
 * @brief   what eyes around a box see of its matter, by rays at random
 *
 * Rays see what slices draw that are very thin: what is scattered once by the lights' own
 * transmittance, found along a ray to each light, and the solver's field where the eye looks,
 * linear between the middles of cells. All is of the first colour, of lights of colour 1; there are
 * no mirrors.
 */
class SeenLight
{
public:
  SeenLight(const interlume::ScatteringMedium& medium,
    const std::vector<interlume::ScatteringLight>& lights, double g);

  /// Energy as in ScatteringReport, with the standard error of the difference.
  struct Energy
  {
    double Incoming = 0.0;
    double Seen = 0.0;
    double Error = 0.0;
  };
  /// Returns what matter takes of the lights, and what is seen in all directions of each field; no
  /// field is what is scattered once.
  std::vector<Energy> GetEnergy(
    const std::vector<const interlume::ScatteringField*>& fields, int rays, unsigned seed) const;

private:
  class Walk;

  double GetTaken(std::size_t light, class Random& random) const;
  /// Returns what is seen against \a way from \a place on the box, for each field.
  void See(const glm::dvec3& place, const glm::dvec3& way,
    const std::vector<const interlume::ScatteringField*>& fields, class Random& random,
    std::vector<double>& seen, double& through) const;
  double GetSource(const glm::dvec3& place, const glm::dvec3& out,
    const interlume::ScatteringField* field, const std::vector<double>& phases,
    const std::vector<double>& lights) const;
  double GetTransmittance(std::size_t light, const glm::dvec3& place) const;
  double GetPhase(double cosine) const;
  glm::dvec3 Scatter(const glm::dvec3& way, class Random& random) const;
  /// Returns a place on the sides that rays along \a way enter by, and sets the area across them.
  glm::dvec3 PlaceOnSides(const glm::dvec3& way, class Random& random, double& area) const;

  const interlume::ScatteringMedium& Medium;
  const std::vector<interlume::ScatteringLight>& Lights;
  double Anisotropy;
};

}

#endif

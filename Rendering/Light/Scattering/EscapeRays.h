// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_EscapeRays_h
#define interlume_EscapeRays_h

#include "Scattering/SanitizedMedium.h"

#include <vector>

#include <glm/vec3.hpp>

namespace interlume
{

/**
 * @class   EscapeRays
 * @brief   computes the fraction of scattered light that escapes the medium
 *
 * Traces rays in 192 directions, like the view rays of cameras around the box. For each direction,
 * the visible faces of the box have one ray per cell, but at most 8 along an edge. Rays sample the
 * fields, interpolated linearly between cell centers, at the same positions as slices do.
 */
class EscapeRays
{
public:
  /**
   * A source of scattered light. Per unit of optical depth, a cell scatters its albedo times
   * Fluence (1 + NetFluxFactor NetFlux . w) into direction w. If Light is set, Fluence travels in
   * the direction of Light, and the factor in parentheses is replaced with the phase function
   * toward w relative to an isotropic one.
   */
  struct Source
  {
    const std::vector<glm::vec3>* Fluence = nullptr;
    const std::vector<glm::vec3>* NetFlux = nullptr;
    double NetFluxFactor = 0.0;
    const ScatteringLight* Light = nullptr;
  };
  /// Sums over the box, per color channel.
  struct Sums
  {
    /// Light that interacts with the medium again.
    glm::dvec3 Recaptured{ 0.0 };
    /// Light that leaves the box against and along the direction passed to Trace.
    glm::dvec3 Backward{ 0.0 };
    glm::dvec3 Forward{ 0.0 };
    /// Light absorbed by blocked cells.
    glm::dvec3 Blocked{ 0.0 };

    glm::dvec3 GetEscaped() const { return this->Backward + this->Forward + this->Blocked; }
    void Add(const Sums& other);
    void Scale(const glm::dvec3& factor);
    /// Scales all parts by one factor so that their sum is \a sent.
    void ScaleTo(const glm::dvec3& sent);
    /// Corrects for the optical depth that the rays miss. \a medium is the ratio of the true
    /// optical depth to the sampled one. The correction is proportional to the escaping fraction,
    /// because light escapes from thick media only near the surface.
    void CorrectOpticalDepth(double medium);
  };

  /// Traces several sources at once and returns the sums of each. \a direction separates the
  /// escaping light into Backward and Forward.
  static std::vector<Sums> Trace(const SanitizedMedium& medium, const PhaseFunction& phase,
    const std::vector<Source>& sources, const glm::dvec3& direction);
};

}

#endif

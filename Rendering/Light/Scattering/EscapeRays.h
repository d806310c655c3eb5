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
 * Traces rays in 192 directions, like the view rays of cameras around the box. In each direction,
 * there is one ray per cell on the visible faces of the box, but at most 8 along an edge. Fields
 * are interpolated linearly between cell centers and sampled at the positions where slices sample
 * them.
 */
class EscapeRays
{
public:
  /**
   * Light that a cell scatters into direction w per unit of optical depth: its albedo times Fluence
   * (1 + NetFluxFactor NetFlux . w). If Light is set, Fluence is light that travels in the
   * direction of that light's rays, and the factor in parentheses is replaced by the phase function
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
    /// Light that leaves the box, by the sign of its component along the direction passed to Trace.
    glm::dvec3 Backward{ 0.0 };
    glm::dvec3 Forward{ 0.0 };
    /// Light absorbed by blocked cells.
    glm::dvec3 Blocked{ 0.0 };

    glm::dvec3 GetOut() const { return this->Backward + this->Forward + this->Blocked; }
    void Add(const Sums& other);
    void Scale(const glm::dvec3& factor);
    /// Scales all parts by one factor so that their sum is \a sent.
    void ScaleTo(const glm::dvec3& sent);
    /// Scales by \a medium, the ratio of the medium's optical depth to the optical depth that the
    /// rays sample. The larger the escaping fraction, the more of this correction applies: light
    /// escapes from thick media only near the surface.
    void ScaleOut(double medium);
  };

  /// Traces several sources at once. Light that leaves in a direction with a negative component
  /// along \a direction is summed separately.
  static std::vector<Sums> Trace(const SanitizedMedium& medium, const PhaseFunction& phase,
    const std::vector<Source>& sources, const glm::dvec3& direction);
};

}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SingleScatteringEscape_h
#define interlume_SingleScatteringEscape_h

#include "Scattering/EscapeRays.h"
#include "Scattering/SanitizedMedium.h"

#include <cstddef>
#include <vector>

namespace interlume
{

/**
 * @class   SingleScatteringEscape
 * @brief   computes the fraction of singly scattered light that escapes the medium
 *
 * Follows 16384 random paths per light. A path enters a cell through a random point of its lit
 * faces, is scattered inside it, and continues in a direction sampled from the phase function.
 * Cells are sampled in proportion to the light that they scatter. Paths are weighted by the light
 * incident on the cell's face and the fraction extinguished inside the cell. Therefore the
 * transmittance within cells is exact for any optical depth. The paths use a low-discrepancy
 * sequence and are the same in each run.
 */
class SingleScatteringEscape
{
public:
  explicit SingleScatteringEscape(const PhaseFunction& phase);

  /// Returns the sums for the singly scattered light of one light. \a direction separates the
  /// escaping light into Backward and Forward.
  EscapeRays::Sums Find(
    const SanitizedMedium& medium, std::size_t light, const glm::dvec3& direction) const;

private:
  /// Cumulative probability of the scattering angle, at equally spaced angles from 0 to pi.
  std::vector<double> CumulativeProbability;
};

}

#endif

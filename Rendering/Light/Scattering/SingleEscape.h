// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SingleEscape_h
#define interlume_SingleEscape_h

#include "Scattering/EscapeRays.h"
#include "Scattering/MatterCells.h"

#include <cstddef>
#include <vector>

namespace interlume
{

/**
 * @class   SingleEscape
 * @brief   computes how much of the light that is scattered once leaves the medium
 *
 * It follows 16384 paths of a light: from where the light enters a cell, at random on the sides that
 * it shines on, to where it is scattered there, and on in a direction that the phase function
 * gives. Cells have paths by what they scatter, and a path counts by the light that comes to its
 * cell's side and what the cell takes of it on the way. So it is the transmittance itself that
 * counts within cells too, as eyes see it, however thick they are. Random numbers are those of an
 * even sequence, the same each time.
 */
class SingleEscape
{
public:
  explicit SingleEscape(const PhaseFunction& phase);

  /// Returns what becomes of a light's scattered light; what leaves against \a direction is apart.
  EscapeRays::Sums Find(
    const MatterCells& matter, std::size_t light, const glm::dvec3& direction) const;

private:
  /// The share of the light that is scattered by less than an angle, at even angles from 0 to pi.
  std::vector<double> Shares;
};

}

#endif

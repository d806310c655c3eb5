// SPDX-License-Identifier: BSD-3-Clause
#ifndef TransportFlight_h
#define TransportFlight_h

#include "Support/Transport/TransportMedium.h"
#include "Support/Transport/TransportPhase.h"
#include "Support/Transport/TransportRandom.h"

namespace reference
{

/**
 * What happens to light between two collisions, without bias for any medium.
 */
namespace TransportFlight
{
/**
 * Returns the distance to where light meets matter next, infinite where it leaves. Delta tracking:
 * E. Woodcock et al., "Techniques used in the GEM code for Monte Carlo neutronics calculations",
 * 1965.
 */
double SampleCollision(
  const TransportMedium& medium, const TransportRay& ray, TransportRandom& random);

/**
 * Returns an estimate of the share of light that comes through up to \a end. Residual ratio
 * tracking: J. Novak et al., "Residual ratio tracking for estimating attenuation in participating
 * media", 2014; exact in cells where the extinction is the same everywhere.
 */
double EstimateTransmittance(
  const TransportMedium& medium, const TransportRay& ray, double end, TransportRandom& random);

/**
 * Ends paths that carry little, by chance, without bias: returns false where the path ends, else
 * multiplies \a weight by what makes up for those that have.
 */
bool Survives(glm::dvec3& weight, TransportRandom& random);
}

}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef TransportFlight_h
#define TransportFlight_h

#include "Support/Transport/TransportMedium.h"
#include "Support/Transport/TransportPhase.h"
#include "Support/Transport/TransportRandom.h"

namespace reference
{

/**
 * Unbiased estimates of collisions and transmittance along a ray in any medium.
 */
namespace TransportFlight
{
/**
 * Returns the distance to the next collision, or infinity if the light leaves the medium. Uses
 * delta tracking: E. Woodcock et al., "Techniques used in the GEM code for Monte Carlo neutronics
 * calculations", 1965.
 */
double SampleCollision(
  const TransportMedium& medium, const TransportRay& ray, TransportRandom& random);

/**
 * Returns an estimate of the transmittance up to the distance \a end. Uses residual ratio tracking:
 * J. Novak et al., "Residual ratio tracking for estimating attenuation in participating media",
 * 2014. The estimate is exact in homogeneous cells.
 */
double EstimateTransmittance(
  const TransportMedium& medium, const TransportRay& ray, double end, TransportRandom& random);

/**
 * Applies Russian roulette to a path if its weight is small. Returns false if the path ends,
 * otherwise scales \a weight to compensate for terminated paths.
 */
bool ApplyRussianRoulette(glm::dvec3& weight, TransportRandom& random);
}

}

#endif

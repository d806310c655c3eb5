// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceShadow_h
#define ReferenceShadow_h

#include "Support/Images/ReferenceMedium.h"

namespace reference
{

/**
 * Returns the optical depth of the medium for red, green and blue, from \a world along the unit
 * vector \a direction up to \a distance. The part of the ray in each voxel is divided into \a
 * refinement steps, each integrated with the two-point Gauss rule. The result is exact if the
 * extinction is linear along the ray in each voxel, and of fourth order if it is smooth. Stops
 * early when the transmittance is negligible.
 */
Double3 GetOpticalDepth(const ReferenceMedium& medium, const Double3& world,
  const Double3& direction, double distance, int refinement);

/// Returns exp(-depth).
Double3 ToTransmittance(const Double3& depth);

}

#endif

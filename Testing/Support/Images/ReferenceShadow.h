// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceShadow_h
#define ReferenceShadow_h

#include "Support/Images/ReferenceMedium.h"

namespace reference
{

/**
 * Returns the optical depth of the medium for red, green and blue, from \a world along \a direction
 * (of length 1) over \a distance. Parts between planes of samples are divided into \a refinement
 * steps, integrated with the two-point Gauss rule. This is exact for extinctions that are linear
 * along the ray in each part, and of fourth order for smooth extinctions. Stops early when the
 * transmittance is negligible.
 */
Double3 GetOpticalDepth(const ReferenceMedium& medium, const Double3& world,
  const Double3& direction, double distance, int refinement);

/// Returns exp(-depth).
Double3 ToTransmittance(const Double3& depth);

}

#endif

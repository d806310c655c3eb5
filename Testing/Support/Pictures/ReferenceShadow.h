// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceShadow_h
#define ReferenceShadow_h

#include "Support/Pictures/ReferenceMedium.h"

namespace reference
{

/**
 * The optical depth, for red, green and blue, of the medium from \a world so far along \a direction
 * (length 1), by Gauss's rule with two points on each 1/\a refinement of the parts between planes
 * of samples: exact for extinctions linear along the ray there, of fourth order for smooth ones.
 * Ends early at depths of which nothing comes through.
 */
Double3 GetOpticalDepth(const ReferenceMedium& medium, const Double3& world,
  const Double3& direction, double distance, int refinement);

/// exp(-depth).
Double3 ToTransmittance(const Double3& depth);

}

#endif

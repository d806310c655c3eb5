// SPDX-License-Identifier: BSD-3-Clause
#ifndef SlabTransport_h
#define SlabTransport_h

#include "Support/Transport/TransportEstimate.h"
#include "Support/Transport/TransportPhase.h"

#include <cstdint>

namespace reference
{

/**
 * A slab of matter that is the same everywhere, without reflection at its surfaces, in parallel
 * light.
 */
struct SlabTransportSettings
{
  /// Extinction times thickness; above 0.
  double Depth = 1.0;
  /// 0 to 1.
  double Albedo = 1.0;
  TransportPhase Phase;
  /// Of the angle between light and the slab's normal; above 0, at most 1.
  double Cosine = 1.0;
  /// What delta tracking takes for the largest extinction, times the true one; 1 or more.
  double Majorant = 1.0;
  std::uint64_t Paths = 1000000;
  std::uint64_t Seed = 1;
};

/**
 * Flux over incident flux, through the slab's surfaces.
 */
struct SlabTransportResult
{
  TransportEstimate Reflected;
  /// Scattered at least once.
  TransportEstimate Transmitted;
  /// Never scattered: exp(-depth / cosine).
  double Direct = 0.0;
};

/**
 * Computes reflection and transmission of a slab by paths of light. Every path is made to collide;
 * what that takes is its weight. The same for any number of threads.
 *
 * Between collisions that scatter, the depth light has reached plus mu / (1 - g), mu the cosine of
 * its direction, is a martingale: its mean where paths end is that where they began. So it is a
 * control variate: a path's score less a multiple of it has the same mean and less variance, a
 * hundredth for deep slabs that do not absorb.
 */
SlabTransportResult TraceSlab(const SlabTransportSettings& settings);

}

#endif

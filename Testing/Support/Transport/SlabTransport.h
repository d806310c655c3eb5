// SPDX-License-Identifier: BSD-3-Clause
#ifndef SlabTransport_h
#define SlabTransport_h

#include "Support/Transport/TransportEstimate.h"
#include "Support/Transport/TransportPhase.h"

#include <cstdint>

namespace reference
{

/**
 * A homogeneous slab in directional light, without reflection at its surfaces.
 */
struct SlabTransportSettings
{
  /// Optical depth (extinction times thickness), greater than 0.
  double Depth = 1.0;
  /// 0 to 1.
  double Albedo = 1.0;
  TransportPhase Phase;
  /// Cosine of the angle between the light and the slab's normal, in (0, 1].
  double Cosine = 1.0;
  /// Majorant of delta tracking relative to the extinction, at least 1.
  double Majorant = 1.0;
  std::uint64_t Paths = 1000000;
  std::uint64_t Seed = 1;
};

/**
 * Flux through the slab's surfaces relative to the incident flux.
 */
struct SlabTransportResult
{
  TransportEstimate Reflected;
  /// Flux of transmitted light that was scattered at least once.
  TransportEstimate Transmitted;
  /// Flux of transmitted light that was not scattered: exp(-depth / cosine).
  double Direct = 0.0;
};

/**
 * Computes reflection and transmission of a slab by path tracing. Every path is forced to collide
 * at least once and weighted by the probability of a collision. The result is independent of the
 * number of threads.
 *
 * Between scattering events, the current depth plus mu / (1 - g), where mu is the cosine of the
 * direction, is a martingale: its mean at the end of the paths equals its mean at the start.
 * It is therefore used as a control variate. Subtracting a multiple of it from a path's score keeps
 * the mean and reduces the variance, especially for deep slabs without absorption.
 */
SlabTransportResult TraceSlab(const SlabTransportSettings& settings);

}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef PictureTransport_h
#define PictureTransport_h

#include "Support/Pictures/RgbaPicture.h"
#include "Support/Transport/TransportMedium.h"
#include "Support/Transport/TransportPhase.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace reference
{

/**
 * Parallel light.
 */
struct TransportLight
{
  /// In which it goes; length 1.
  glm::dvec3 Direction{ 0.0, 0.0, 1.0 };
  /// In units in which thin matter of albedo 1 that scatters it evenly has this colour.
  glm::dvec3 Color{ 1.0, 1.0, 1.0 };
};

/**
 * What a picture of scattered light is made of, apart from matter and the lines of sight.
 */
struct PictureTransportSettings
{
  TransportPhase Phase;
  std::vector<TransportLight> Lights;
  /// Colour of light that comes evenly from everywhere, as what is seen of it.
  glm::dvec3 Surroundings{ 0.0, 0.0, 0.0 };
  /// How often light is scattered at most before it is seen; 0 for without end.
  int MaximumScatterings = 0;
  std::uint64_t PathsPerPixel = 64;
  std::uint64_t Seed = 1;
};

/**
 * The mean over paths, and in each channel the standard deviation of that mean. Colours are those
 * of matter alone, times its opacity, which is alpha: surroundings seen through it are not in them.
 */
struct TransportPicture
{
  RgbaPicture Mean;
  RgbaPicture StandardError;
};

/// The line of sight of a pixel, counted from the lower left; it begins outside of the matter.
using SightLines = std::function<TransportRay(int i, int j)>;

/**
 * Computes a picture by paths from the eye, which ask for each light's share where they are
 * scattered. The same for any number of threads.
 */
TransportPicture TracePicture(const TransportMedium& medium, int width, int height,
  const SightLines& lines, const PictureTransportSettings& settings);

}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef ImageTransport_h
#define ImageTransport_h

#include "Support/Images/RgbaImage.h"
#include "Support/Transport/TransportMedium.h"
#include "Support/Transport/TransportPhase.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace reference
{

/**
 * A directional light.
 */
struct TransportLight
{
  /// Direction of propagation, of length 1.
  glm::dvec3 Direction{ 0.0, 0.0, 1.0 };
  /// Color that a thin, isotropically scattering medium with albedo 1 has in this light.
  glm::dvec3 Color{ 1.0, 1.0, 1.0 };
};

/**
 * Settings for rendering scattered light, in addition to the medium and the view rays.
 */
struct ImageTransportSettings
{
  TransportPhase Phase;
  std::vector<TransportLight> Lights;
  /// Radiance of uniform light from all directions.
  glm::dvec3 Surroundings{ 0.0, 0.0, 0.0 };
  /// Maximum number of scattering events, or 0 for no limit.
  int MaximumScatterings = 0;
  std::uint64_t PathsPerPixel = 64;
  std::uint64_t Seed = 1;
};

/**
 * Mean over paths and its standard error for each channel. Colors are premultiplied by alpha, the
 * opacity of the medium. They exclude the surroundings that are visible through the medium.
 */
struct TransportImage
{
  RgbaImage Mean;
  RgbaImage StandardError;
};

/// Returns the view ray of pixel (i, j), counted from the lower left. The ray must start outside
/// the medium.
using SightLines = std::function<TransportRay(int i, int j)>;

/**
 * Renders an image by tracing paths from the camera. At each scattering event, the direct light of
 * all sources is added. The result is independent of the number of threads.
 */
TransportImage TraceImage(const TransportMedium& medium, int width, int height,
  const SightLines& lines, const ImageTransportSettings& settings);

}

#endif

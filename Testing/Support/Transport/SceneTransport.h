// SPDX-License-Identifier: BSD-3-Clause
#ifndef SceneTransport_h
#define SceneTransport_h

#include "Support/Images/ShadowScene.h"
#include "Support/Transport/ImageTransport.h"

#include <cstdint>

namespace reference
{

/**
 * Settings of scattering and path tracing in a volume.
 */
struct SceneTransportSettings
{
  TransportPhase Phase;
  /// Albedo function. If null, the colors of the volume are used.
  vtkSmartPointer<vtkColorTransferFunction> Albedo;
  /// Maximum number of scattering events, or 0 for no limit.
  int MaximumScatterings = 0;
  std::uint64_t PathsPerPixel = 64;
  std::uint64_t Seed = 1;
};

/**
 * Renders a volume with scattered light, as vtkShadowedSliceMapper does, with view rays through the
 * pixel centers. The image data must be axis-aligned, the volume must not have a matrix, all lights
 * must be directional, and no actor is allowed. Throws std::invalid_argument otherwise, and if the
 * image has no active one-component point scalars.
 */
TransportImage TraceScene(const ShadowScene& scene, const SceneTransportSettings& settings);

}

#endif

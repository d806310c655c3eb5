// SPDX-License-Identifier: BSD-3-Clause
#ifndef SceneTransport_h
#define SceneTransport_h

#include "Support/Pictures/ShadowScene.h"
#include "Support/Transport/PictureTransport.h"

#include <cstdint>

namespace reference
{

/**
 * How light is scattered in a volume, and how many paths follow it.
 */
struct SceneTransportSettings
{
  TransportPhase Phase;
  /// The volume's colours where it is null.
  vtkSmartPointer<vtkColorTransferFunction> Albedo;
  /// As PictureTransportSettings have it.
  int MaximumScatterings = 0;
  std::uint64_t PathsPerPixel = 64;
  std::uint64_t Seed = 1;
};

/**
 * Traces the picture that vtkShadowedSliceMapper draws of a volume whose light is scattered,
 * through the middles of the pixels. The image has no axes of its own and the volume no matrix, all
 * lights are directional, and nothing is opaque: std::invalid_argument for others, and as
 * VolumeMedium.
 */
TransportPicture TraceScene(const ShadowScene& scene, const SceneTransportSettings& settings);

}

#endif

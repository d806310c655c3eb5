// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Pictures/ReferenceShadowPicture.h"

#include "Support/Pictures/MixedScene.h"
#include "Support/Pictures/ReferenceMixedPicture.h"

namespace reference
{

RgbaPicture MakeShadowPicture(const ShadowScene& scene, int refinement)
{
  MixedScene mixed;
  mixed.Volumes = { scene };
  for (const auto& light : scene.Lights)
  {
    mixed.Lights.push_back({ light, {} });
  }
  mixed.Camera = scene.Camera;
  mixed.Shadows = scene.Shadows;
  mixed.Size = scene.Size;
  mixed.OpaqueDistance = scene.OpaqueDistance;
  return MakeMixedPicture(mixed, refinement);
}

}

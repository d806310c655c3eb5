// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Images/ReferenceShadowImage.h"

#include "Support/Images/MixedScene.h"
#include "Support/Images/ReferenceMixedImage.h"

namespace reference
{

RgbaImage MakeShadowImage(const ShadowScene& scene, int refinement)
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
  return MakeMixedImage(mixed, refinement);
}

}

// SPDX-License-Identifier: BSD-3-Clause
#ifndef MixedCases_h
#define MixedCases_h

#include "Support/Images/MixedScene.h"
#include "Support/Images/ShadowScene.h"

#include <string>

/**
 * Scenes of the suite `mixed`. Media and surfaces are white, without ambient or specular
 * reflection.
 */
namespace mixed
{
struct Case
{
  std::string Name;
  reference::MixedScene Scene;
  /// Initial position of the first light, to restore it after the lights have moved.
  reference::Double3 LightPosition{};
};

/// Returns a plane at z = -0.6 with nine posts on it and a box and a sphere above it, lit by a
/// spotlight and seen from above. The sphere has about \a triangles triangles.
Case MakePosts(int pixels, int triangles);

/// Returns a volume surrounded by spheres that have about \a triangles triangles in total.
Case MakeVolumeAmongSpheres(
  const std::string& name, const reference::ShadowScene& volume, int pixels, int triangles);
}

#endif

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
  /// Initial position of the first light, to restore it after frames that move the lights.
  reference::Double3 LightPosition{};
};

/// Returns a box, a sphere and nine posts on the plane z = -0.6 under a spotlight, seen from above.
/// The sphere has about \a triangles triangles.
Case MakePosts(int pixels, int triangles);

/// Returns a volume surrounded by spheres that have about \a triangles triangles in total.
Case MakeAmongSpheres(
  const std::string& name, const reference::ShadowScene& volume, int pixels, int triangles);
}

#endif

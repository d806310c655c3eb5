// SPDX-License-Identifier: BSD-3-Clause
#ifndef MixedCases_h
#define MixedCases_h

#include "Support/Pictures/MixedScene.h"
#include "Support/Pictures/ShadowScene.h"

#include <string>

/**
 * The scenes of the suite `mixed`: white media and surfaces without ambient and specular light.
 */
namespace mixed
{
struct Case
{
  std::string Name;
  reference::MixedScene Scene;
  /// Position of the first light: frames that move lights leave them elsewhere.
  reference::Double3 LightPosition{};
};

/// A box, a ball and nine posts on the plane z = -0.6, of about so many triangles, under a
/// spotlight; seen from above.
Case MakePosts(int pixels, int triangles);

/// Balls of about so many triangles in all around a volume.
Case MakeAmongBalls(
  const std::string& name, const reference::ShadowScene& volume, int pixels, int triangles);
}

#endif

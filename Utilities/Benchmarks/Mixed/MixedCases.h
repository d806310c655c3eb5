// SPDX-License-Identifier: BSD-3-Clause
#ifndef MixedCases_h
#define MixedCases_h

#include "Support/Pictures/MixedScene.h"

#include <string>
#include <vector>

/**
 * The scenes of the suite `mixed`: white matter, without ambient and specular light, above the
 * plane z = -0.6, unless they say so.
 */
namespace mixed
{
struct Case
{
  std::string Name;
  reference::MixedScene Scene;
  /// Where the first light is: frames that move lights leave them elsewhere.
  reference::Double3 LightPosition{};
};

/// A square picture of so many pixels and no perspective, 2.2 units wide, of the origin. A row of
/// it is along x where \a direction has none.
vtkSmartPointer<vtkCamera> LookAlong(const reference::Double3& direction);
/// White light along a direction, of intensity 1; each casts full shadows.
vtkSmartPointer<vtkLight> MakeSun(const reference::Double3& direction);

/**
 * A box behind, in, across and before a slab of smoke between light and plane, under parallel
 * light; behind it also under light against the eye's direction and from a lamp, and below two
 * slabs that overlap.
 */
std::vector<Case> MakeSlabs(int pixels);

/// A box, a ball and nine posts on the plane, of about so many triangles, under a spotlight; seen
/// from above.
Case MakePosts(int pixels, int triangles);

/// Balls around the bonsai, thinned to every so many samples along each axis, or in a blob of smoke
/// of points^3 points, of about so many triangles in all.
Case MakeBonsaiAmongBalls(int pixels, int step, int triangles);
Case MakeSmokeAmongBalls(int pixels, int points, int triangles);

/// Small scenes that eye and light go around: the slab, plate and ball in smoke, a rod through
/// rings, two volumes that overlap, and the bonsai among balls.
std::vector<Case> MakeTurned(int pixels, int points);
}

#endif

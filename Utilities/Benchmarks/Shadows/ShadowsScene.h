// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShadowsScene_h
#define ShadowsScene_h

#include "Support/Pictures/ShadowScene.h"

#include <string>
#include <vector>

/**
 * What the suite `shadows` draws.
 */
namespace shadows
{
struct Case
{
  std::string Name;
  /// With the light of MakeLights(1) and a picture of 512^2.
  reference::ShadowScene Scene;
};

/// The cases with pictures of so many pixels along both edges.
std::vector<Case> WithPixels(std::vector<Case> cases, int pixels);

/**
 * bonsai.vti, a CT set of 256^3 bytes, thinned to every so many samples along x and y, and along z.
 * Opacity rises as for a surface from nothing to 0.9 a voxel within 30 of 255 values. Shade is on.
 * `bonsai-<x>x<y>x<z>`. Throws std::runtime_error where the file cannot be read.
 */
Case MakeBonsai(int stepXY, int stepZ);

/**
 * The sphere of equation 2.7 of C. Zhang (dissertation, Ohio State 2006) on points^3 points of a
 * cube: haze, of optical depth 6 through the middle if it were homogeneous. Shade is on.
 * `sphere-<points>`.
 */
Case MakeSphere(int points);

/**
 * Seven tori of vtkConstructiveModelSource on points^3 points of a cube, nearly opaque. Shade is
 * on. `rings-<points>`.
 */
Case MakeRings(int points);

/**
 * A round blob of thin smoke with holes, the displaced sphere of figure 2.12, on points^3 points.
 * `smoke-<points>`.
 */
Case MakeSmoke(int points);

/**
 * A nearly opaque box before a slab that lets light through, on points^3 points of a cube.
 * `box-<points>`.
 */
Case MakeBox(int points);

/**
 * The same matter, each part of which scatters light evenly: C = c kd I T, without ambient light.
 * vtkShadowedSliceMapper draws it so with Shade off, vtkGPUVolumeRayCastMapper's volumetric shadows
 * with Shade on.
 */
Case MakeScattering(const Case& from);

using Lights = std::vector<vtkSmartPointer<vtkLight>>;

/// White directional lights on the viewer's side, 1 to 8, together of intensity 1.
Lights MakeLights(const reference::ShadowScene& scene, int number);
/// A round vtkAreaLight in the direction of MakeLights(1), one and a half diagonals of the image
/// from its middle, of so many diagonals; positional.
Lights MakeAreaLights(const reference::ShadowScene& scene, double size);
}

#endif

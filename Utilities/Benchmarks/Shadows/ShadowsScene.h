// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShadowsScene_h
#define ShadowsScene_h

#include "Support/Images/ShadowScene.h"

#include <string>
#include <vector>

/**
 * Scenes of the suite `shadows`.
 */
namespace shadows
{
struct Case
{
  std::string Name;
  /// The scene with the light of MakeLights(1). Initially it is rendered with 512^2 pixels.
  reference::ShadowScene Scene;
};

/// Returns the cases with an image size of \a pixels x \a pixels.
std::vector<Case> WithPixels(std::vector<Case> cases, int pixels);

/**
 * Returns the case `bonsai-<x>x<y>x<z>`: bonsai.vti, a CT scan of 256^3 bytes, subsampled by \a
 * stepXY along x and y and by \a stepZ along z. Opacity rises steeply, from 0 to 0.9 per voxel
 * within 30 of 255 values. Shade is on. Throws std::runtime_error if the file cannot be read.
 */
Case MakeBonsai(int stepXY, int stepZ);

/**
 * Returns the case `sphere-<points>`: the sphere of equation 2.7 of C. Zhang (dissertation, Ohio
 * State 2006) on points^3 points of a cube. It is a haze. If it were homogeneous, its optical depth
 * through the center would be 6. Shade is on.
 */
Case MakeSphere(int points);

/**
 * Returns the case `rings-<points>`: seven nearly opaque tori of vtkConstructiveModelSource on
 * points^3 points of a cube. Shade is on.
 */
Case MakeRings(int points);

/**
 * Returns the case `smoke-<points>`: a sphere of thin smoke with holes, the displaced sphere of
 * figure 2.12 of C. Zhang's dissertation, on points^3 points.
 */
Case MakeSmoke(int points);

/**
 * Returns the case `box-<points>`: a nearly opaque box in front of a translucent slab, on points^3
 * points of a cube.
 */
Case MakeBox(int points);

/**
 * Returns the case \a from with isotropic single scattering: color times diffuse coefficient times
 * light intensity times transmittance, without ambient light. vtkShadowedSliceMapper renders it
 * with Shade off. The volumetric shadows of vtkGPUVolumeRayCastMapper require Shade on.
 */
Case MakeScattering(const Case& from);

using Lights = std::vector<vtkSmartPointer<vtkLight>>;

/// Returns 1 to 8 white directional lights on the viewer's side, with a total intensity of 1.
Lights MakeLights(const reference::ShadowScene& scene, int number);
/// Returns a round, positional vtkAreaLight in the direction of MakeLights(1), at a distance of 1.5
/// diagonals of the volume from its center. \a size is the light's diameter divided by the
/// diagonal.
Lights MakeAreaLights(const reference::ShadowScene& scene, double size);
}

#endif

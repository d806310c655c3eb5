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
  /// The scene with the single light of MakeLights(). The image size is 512^2 pixels unless
  /// WithPixels() changes it.
  reference::ShadowScene Scene;
};

/// Returns \a cases with an image size of \a pixels x \a pixels.
std::vector<Case> WithPixels(std::vector<Case> cases, int pixels);

/**
 * Returns the case `bonsai-<x>x<y>x<z>`: bonsai.vti, a CT scan of 256^3 8-bit voxels, subsampled by
 * \a stepXY along x and y and by \a stepZ along z. Opacity rises steeply, from 0 to 0.9 per voxel
 * over 30 of the 256 scalar values. Shade is on. Throws std::runtime_error if the file cannot be
 * read.
 */
Case MakeBonsai(int stepXY, int stepZ);

/**
 * Returns the case `sphere-<points>`: the fuzzy sphere of equation 2.7 of C. Zhang's dissertation
 * (Ohio State 2006), sampled on points^3 points of a cube. A homogeneous sphere with the maximum
 * value would have an optical depth of 6 through its center. Shade is on.
 */
Case MakeSphere(int points);

/**
 * Returns the case `rings-<points>`: the seven tori of vtkConstructiveModelSource, nearly opaque,
 * sampled on points^3 points of a cube. Shade is on.
 */
Case MakeRings(int points);

/**
 * Returns the case `smoke-<points>`: a sphere of thin smoke with holes (the displaced sphere of
 * figure 2.12 of C. Zhang's dissertation), sampled on points^3 points of a cube.
 */
Case MakeSmoke(int points);

/**
 * Returns the case `box-<points>`: a nearly opaque box in front of a translucent slab, sampled on
 * points^3 points of a cube.
 */
Case MakeBox(int points);

/**
 * Returns a copy of \a from that models isotropic single scattering: color times diffuse
 * coefficient times light intensity times transmittance, without ambient light. Shade is off, as
 * vtkShadowedSliceMapper requires for this model. The volumetric shadows of
 * vtkGPUVolumeRayCastMapper require Shade on (see MakeShadowRayMethod()).
 */
Case MakeScatteringCase(const Case& from);

using Lights = std::vector<vtkSmartPointer<vtkLight>>;

/// Returns 1 to 8 white directional lights on the viewer's side, with a total intensity of 1.
Lights MakeLights(const reference::ShadowScene& scene, int number);
/// Returns a round, positional vtkAreaLight in the direction of the first light of MakeLights(), at
/// a distance of 1.5 volume diagonals from the center of the volume. \a size is the diameter of the
/// light divided by the diagonal.
Lights MakeAreaLights(const reference::ShadowScene& scene, double size);
}

#endif

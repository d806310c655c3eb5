// SPDX-License-Identifier: BSD-3-Clause
#ifndef HalfPlane_h
#define HalfPlane_h

#include "Support/Pictures/RgbaPicture.h"
#include "Support/Pictures/ShadowScene.h"

#include <vector>

/**
 * The penumbra of a half plane in the light of a strip, whose profile is an even ramp.
 */
namespace reference
{

/// A sheet that is opaque for x < 0 in the plane z = 0, a receiver half a unit below, both two
/// voxels thick, and a positional vtkAreaLight at a height above the sheet; seen from below, along
/// the light. The exact penumbra is \a width wide, at most 0.2; \a ratio is the receiver's distance
/// from the sheet over the light's, equation 2.14's dZ / Z.
ShadowScene MakeHalfPlane(double ratio, double width);

/// The width of a pixel of that scene's picture, on the receiver.
double GetHalfPlanePixel();

/// What of the light arrives along the receiver, in shares of that of a point light without an
/// occluder, a value each pixel from x = -57.5 pixels on, where all is dark.
std::vector<double> GetPenumbra(const RgbaPicture& picture);

/// The width of the even ramp that has the spread of the profile's slope. What a profile is off by
/// far from its middle counts by the square of its distance.
double GetRampWidth(const std::vector<double>& profile);

/// The width of the even ramp from 0 to 1, anywhere, that is nearest to the profile in the mean
/// square.
double FitRampWidth(const std::vector<double>& profile);

}

#endif

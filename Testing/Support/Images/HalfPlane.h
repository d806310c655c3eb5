// SPDX-License-Identifier: BSD-3-Clause
#ifndef HalfPlane_h
#define HalfPlane_h

#include "Support/Images/RgbaImage.h"
#include "Support/Images/ShadowScene.h"

#include <vector>

/**
 * The penumbra that a half-plane casts in the light of a strip. Its profile is a linear ramp.
 */
namespace reference
{

/// Returns a scene of an opaque sheet with x < 0 in the plane z = 0, a receiver half a unit below,
/// and a positional vtkAreaLight above. The sheet and the receiver are two voxels thick. The camera
/// looks up from below. The exact penumbra is \a width wide, at most 0.2. \a ratio is the
/// receiver's distance from the sheet divided by the light's distance from the sheet, dZ / Z in
/// equation 2.14 of C. Zhang's dissertation.
ShadowScene MakeHalfPlane(double ratio, double width);

/// Returns the width that a pixel of MakeHalfPlane()'s image has on the receiver.
double GetHalfPlanePixel();

/// Returns the light along the receiver as a fraction of the unoccluded light. There is one value
/// per pixel, starting at x = -57.5 pixels in full shadow.
std::vector<double> GetPenumbra(const RgbaImage& rendered);

/// Returns the width of the linear ramp whose slope has the same standard deviation as the slope of
/// the profile. Errors of the profile far from its center have a large effect, since they are
/// weighted by the squared distance.
double GetRampWidth(const std::vector<double>& profile);

/// Returns the width of the linear ramp from 0 to 1 that fits the profile best by least squares.
/// The position of the ramp is free.
double FitRampWidth(const std::vector<double>& profile);

}

#endif

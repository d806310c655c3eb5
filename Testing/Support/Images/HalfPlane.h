// SPDX-License-Identifier: BSD-3-Clause
#ifndef HalfPlane_h
#define HalfPlane_h

#include "Support/Images/RgbaImage.h"
#include "Support/Images/ShadowScene.h"

#include <vector>

/**
 * The penumbra of a half-plane that is lit by a strip. Its exact profile is a linear ramp.
 */
namespace reference
{

/// Returns a scene with an opaque sheet at x < 0 in the plane z = 0, a receiver 0.5 below it, and a
/// positional vtkAreaLight above it. The sheet and the receiver are two voxels thick. The camera
/// looks up from below. \a width is the exact width of the penumbra, at most 0.2. \a ratio is the
/// receiver's distance from the sheet divided by the light's distance from the sheet, dZ / Z in
/// equation 2.14 of C. Zhang's dissertation.
ShadowScene MakeHalfPlane(double ratio, double width);

/// Returns the width of a pixel of MakeHalfPlane()'s image in world units.
double GetHalfPlanePixelWidth();

/// Returns the light along x on the receiver as a fraction of the unoccluded light. There is one
/// value per pixel, starting at x = -57.5 pixels in full shadow.
std::vector<double> GetPenumbra(const RgbaImage& rendered);

/// Regards the slope of the profile as a distribution, and returns the width of the linear ramp
/// whose slope has the same standard deviation. Errors far from the center of the profile have a
/// large effect, since they are weighted by the squared distance.
double GetRampWidth(const std::vector<double>& profile);

/// Returns the width of the linear ramp from 0 to 1 that fits the profile best by least squares.
/// The fit also varies the center of the ramp.
double FitRampWidth(const std::vector<double>& profile);

}

#endif

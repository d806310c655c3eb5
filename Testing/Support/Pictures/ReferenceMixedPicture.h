// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceMixedPicture_h
#define ReferenceMixedPicture_h

#include "Support/Pictures/RgbaPicture.h" // for the picture

namespace reference
{

struct MixedScene;

/**
 * The picture of volumes as vtkShadowedSliceMapper.h promises it, and of surfaces as VTK shades
 * them, both in the shadows of both, by marching along the line of sight of each pixel from
 * surface to surface, and along a ray from each place to each point of every light that casts
 * shadows, in double.
 *
 * Steps end at planes between samples, at planes that crop and clip, at surfaces, and where the
 * optical depth has grown by a tenth; in each, the scattered light is that of two points of Gauss.
 * \a refinement divides the steps, of the shadow rays as well: twice as many show how good a
 * picture is. Cut by the near and the far plane of the camera. By as many threads as vtkSMPTools
 * has; the same for any number.
 *
 * std::invalid_argument as ReferenceMedium and ReferenceSurface.
 */
RgbaPicture MakeMixedPicture(const MixedScene& scene, int refinement = 1);

}

#endif

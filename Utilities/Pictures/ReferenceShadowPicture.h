// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceShadowPicture_h
#define ReferenceShadowPicture_h

#include "Pictures/RgbaPicture.h" // for the picture

namespace reference
{

struct ShadowScene;

/**
 * The picture that vtkShadowedSliceMapper.h promises, by marching along the line of sight of each
 * pixel and from each of its samples along a ray to every light that casts shadows, in double.
 *
 * Steps end at planes between samples, at planes that crop and clip, and where the optical depth
 * has grown by a tenth; in each, the scattered light is that of two points of Gauss. \a refinement
 * divides the steps, of the shadow rays as well: twice as many show how good a picture is. Cut by
 * the near plane of the camera. By as many threads as vtkSMPTools has; the same for any number.
 *
 * std::invalid_argument as ReferenceMedium.
 */
RgbaPicture MakeShadowPicture(const ShadowScene& scene, int refinement = 1);

}

#endif

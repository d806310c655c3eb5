// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceShadowPicture_h
#define ReferenceShadowPicture_h

#include "Support/Pictures/RgbaPicture.h" // for the picture

namespace reference
{

struct ShadowScene;

/**
 * The picture that vtkShadowedSliceMapper.h promises of one volume, by MakeMixedPicture. Actors of
 * the scene are known by its opaque distances alone.
 */
RgbaPicture MakeShadowPicture(const ShadowScene& scene, int refinement = 1);

}

#endif

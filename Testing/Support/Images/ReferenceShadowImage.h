// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceShadowImage_h
#define ReferenceShadowImage_h

#include "Support/Images/RgbaImage.h" // for the image

namespace reference
{

struct ShadowScene;

/**
 * Renders one volume with MakeMixedImage(). Uses OpaqueDistance of the scene and ignores its
 * actors.
 */
RgbaImage MakeShadowImage(const ShadowScene& scene, int refinement = 1);

}

#endif

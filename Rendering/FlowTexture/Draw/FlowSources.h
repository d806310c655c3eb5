// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlowSources_h
#define interlume_FlowSources_h

#include "Common/Error.h"

namespace interlume
{

class FlowTextures;
struct FlowPicture;
struct FlowScene;

/**
 * Sends the arrays, images and functions that an image looks up.
 */
namespace FlowSources
{
/**
 * Keeps the textures of an image, and no others. Sets their sizes and ranges in \a picture, and
 * what was sent in its report. Returns an error if a texture cannot be made, or they are too many
 * or too large.
 */
Error Keep(FlowPicture& picture, FlowScene& scene, FlowTextures& textures);
}

}

#endif

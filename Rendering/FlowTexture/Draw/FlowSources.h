// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlowSources_h
#define interlume_FlowSources_h

#include "Common/Error.h"

namespace interlume
{

class FlowTextures;
struct FlowRenderPass;
struct FlowRenderState;

/**
 * Uploads the arrays, images and functions that the shaders of a frame use.
 */
namespace FlowSources
{
/**
 * Updates the textures of a frame and releases all others. Sets sizes and ranges in \a pass, and
 * upload counts in its report. Returns an error if a texture cannot be created, or if there are too
 * many textures or they are too large.
 */
Error Update(FlowRenderPass& pass, FlowRenderState& scene, FlowTextures& textures);
}

}

#endif

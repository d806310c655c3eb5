// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlowSources_h
#define interlume_FlowSources_h

#include "Common/Error.h"

namespace interlume
{

class FlowTextures;
struct FlowRenderFrame;
struct FlowRenderState;

/**
 * Uploads the data arrays, images and transfer functions that the shaders of a frame use.
 */
namespace FlowSources
{
/**
 * Updates the textures of a frame and releases all others. Sets the size of the detail texture, the
 * range of the opacity transfer function and the upload counts in \a pass. Returns an error if a
 * texture cannot be created, or if there are too many textures or they are too large.
 */
Error Update(FlowRenderFrame& pass, FlowRenderState& scene, FlowTextures& textures);
}

}

#endif

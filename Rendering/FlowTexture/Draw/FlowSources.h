// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlowSources_h
#define interlume_FlowSources_h

#include <string>

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
 * what was sent in its report. Returns an error message, or an empty string on success.
 */
std::string Keep(FlowPicture& picture, FlowScene& scene, FlowTextures& textures);
}

}

#endif

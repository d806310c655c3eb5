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
 * @class   FlowSources
 * @brief   sends what a picture looks up: voxels, paint, arrays and functions
 */
class FlowSources
{
public:
  FlowSources(FlowScene& scene, FlowTextures& textures);

  /**
   * Keeps the textures of a picture, and no others; the picture is told their sizes and ranges, its
   * report what was sent. Returns what is wrong, or nothing.
   */
  std::string Keep(FlowPicture& picture);

private:
  std::string KeepGrid(FlowPicture& picture);
  std::string KeepPaints(FlowPicture& picture);
  std::string KeepArrays(FlowPicture& picture);

  FlowScene& Scene;
  FlowTextures& Textures;
};

}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SliceReceivers_h
#define interlume_SliceReceivers_h

#include "Draw/SliceLayerPoints.h"
#include "Draw/SlicePass.h"
#include "Plan/SlicePlan.h"

#include "vtkNew.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

class vtkOpenGLBufferObject;
class vtkOpenGLRenderWindow;
class vtkTextureObject;

namespace interlume
{

class SliceLightBuffer;
class SliceTextures;
struct SliceFrame;
struct SliceScene;

/**
 * @class   SliceReceivers
 * @brief   finds what the slices of a sweep leave of their lights at the surfaces of the scene
 *
 * Each pixel's surface is a point of the slab that it lies in. It is drawn into the scene's
 * transmittance when the lights' buffers have come to that slab: those that no light reaches
 * through the matter not at all, those behind the last slab at the end, by the layers of
 * samples where the light has such.
 */
class SliceReceivers
{
public:
  SliceReceivers();
  ~SliceReceivers();

  /**
   * Sorts the surfaces into slabs, and makes the programs ready. \a buffers are those of the
   * sweep's lights, whose textures are active. Returns what is wrong, or nothing.
   */
  std::string Begin(vtkOpenGLRenderWindow* window, const SliceFrame& frame, std::size_t sweepIndex,
    SliceTextures& textures, const std::vector<SliceLightBuffer*>& buffers);

  /// Draws all surfaces that are left up to the end of a slab, whose matter the buffers do not have
  /// yet; the number of slabs stands for what is behind all of them. Returns the number of passes
  /// over layers that this took.
  int Draw(vtkOpenGLRenderWindow* window, int slab);

  void ReleaseGraphicsResources();

private:
  void Sort(const SliceFrame& frame, const SlicePlan::Sweep& sweep);

  /// A light's programs, the second one where it has layers, and the light's tile in the scene's
  /// transmittance.
  struct Light
  {
    const SlicePlan::ShadowedLight* Planned = nullptr;
    SliceLightBuffer* Buffer = nullptr;
    std::unique_ptr<SlicePass> Pass;
    std::unique_ptr<SliceLayerPoints> Behind;
    int Tile = 0;
  };

  const SliceFrame* Frame = nullptr;
  SliceScene* Scene = nullptr;
  const SlicePlan::Sweep* Sweep = nullptr;
  std::vector<Light> Lights;
  std::vector<float> Places;
  /// The first place of each slab; two more than slabs.
  std::vector<std::size_t> Starts;
  std::size_t Next = 0;
  vtkNew<vtkOpenGLBufferObject> Vertices;
};

}

#endif

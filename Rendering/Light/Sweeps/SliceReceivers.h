// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SliceReceivers_h
#define interlume_SliceReceivers_h

#include "Buffers/SlicePass.h"
#include "Common/Error.h"
#include "Plan/SlicePlan.h"
#include "Sweeps/AreaLightReceivers.h"

#include "vtkNew.h"

#include <cstddef>
#include <memory>
#include <vector>

class vtkOpenGLBufferObject;
class vtkOpenGLRenderWindow;
class vtkTextureObject;

namespace interlume
{

class SliceLightBuffer;
class VolumeSlices;
struct VolumeRenderState;
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

  /// Sorts the surfaces into slabs of a sweep through these volumes.
  void Begin(const std::vector<std::unique_ptr<VolumeSlices>>& volumes, std::size_t sweepIndex);

  /**
   * Makes a volume's programs ready, the first one's first. \a buffers are those of the sweep's
   * lights, whose textures are active. Returns an error if a program cannot be compiled.
   */
  Error Prepare(vtkOpenGLRenderWindow* window, VolumeSlices& slices,
    const std::vector<SliceLightBuffer*>& buffers);

  /// Whether there are surfaces left up to the end of a slab, whose matter the buffers do not have
  /// yet; the number of slabs stands for what is behind all of them.
  bool IsLeft(int slab) const;
  /// Draws what a volume leaves of light at these surfaces. Returns the number of passes over
  /// layers that this took.
  int Draw(vtkOpenGLRenderWindow* window, int slab, std::size_t volume);
  /// Forgets them.
  void Pass(int slab) { this->Next = this->Starts[static_cast<std::size_t>(slab) + 1]; }

  void ReleaseGraphicsResources();

private:
  void Sort(const std::vector<std::unique_ptr<VolumeSlices>>& volumes);

  /// A light's programs of a volume, the second one of the first volume where the light has layers,
  /// and the light's tile in the scene's transmittance.
  struct Light
  {
    const SlicePlan::ShadowedLight* Planned = nullptr;
    SliceLightBuffer* Buffer = nullptr;
    std::unique_ptr<SlicePass> Pass;
    std::unique_ptr<AreaLightReceivers> Behind;
    int Tile = 0;
  };

  const VolumeRenderState* Frame = nullptr;
  SliceScene* Scene = nullptr;
  const SlicePlan::Sweep* Sweep = nullptr;
  /// Of each volume.
  std::vector<std::vector<Light>> Lights;
  std::vector<float> Places;
  /// The first place of each slab; two more than slabs.
  std::vector<std::size_t> Starts;
  std::size_t Next = 0;
  vtkNew<vtkOpenGLBufferObject> Vertices;
};

}

#endif

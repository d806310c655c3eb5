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
 * @brief   computes how volumes attenuate the light on the surfaces of a vtkShadowedScenePass
 *
 * At each pixel, the visible point of a surface lies in some slab of the sweep, or behind all
 * slabs. When the light buffers contain the attenuation up to this slab, the transmittance at the
 * point is multiplied into SliceScene::Transmittance. Points are skipped if no light passes through
 * the medium on its way to them. Points behind the last slab are drawn at the end. For area lights
 * with sample layers, their transmittance is computed from these layers.
 */
class SliceReceivers
{
public:
  SliceReceivers();
  ~SliceReceivers();

  /// Sorts the visible points of the surfaces by the slabs of a sweep through \a volumes.
  void Begin(const std::vector<std::unique_ptr<VolumeSlices>>& volumes, std::size_t sweepIndex);

  /**
   * Prepares a volume's programs. Call it once for each volume, in order. \a buffers are the
   * sweep's light buffers, whose textures must be active. Returns an error if a program cannot be
   * compiled.
   */
  Error Prepare(vtkOpenGLRenderWindow* window, VolumeSlices& slices,
    const std::vector<SliceLightBuffer*>& buffers);

  /// Returns true if points up to the end of \a slab have not been drawn yet. In this method, Draw
  /// and Pass, \a slab may be the number of slabs, to include the points behind the last slab.
  bool HasRemainingPoints(int slab) const;
  /// Multiplies the transmittance at the remaining points up to the end of \a slab by that of a
  /// volume. Call it before the light buffers are attenuated by \a slab. Returns the number of
  /// passes over the sample layers.
  int Draw(vtkOpenGLRenderWindow* window, int slab, std::size_t volume);
  /// Marks the points up to the end of \a slab as drawn.
  void Pass(int slab) { this->Next = this->Starts[static_cast<std::size_t>(slab) + 1]; }

  void ReleaseGraphicsResources();

private:
  void Sort(const std::vector<std::unique_ptr<VolumeSlices>>& volumes);

  /// Programs of a volume for a light, and the light's tile in SliceScene::Transmittance. Behind
  /// draws the points behind the last slab; it is null except in the first volume, for lights with
  /// sample layers.
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
  /// The lights of each volume.
  std::vector<std::vector<Light>> Lights;
  std::vector<float> Positions;
  /// Index of the first point of each slab, followed by the index of the first point behind the
  /// last slab and the number of points.
  std::vector<std::size_t> Starts;
  std::size_t Next = 0;
  vtkNew<vtkOpenGLBufferObject> Vertices;
};

}

#endif

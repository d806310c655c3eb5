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
 * @brief   computes the transmittance of a sweep's slices at the surfaces of a scene
 *
 * The surface seen at each pixel is a point in a slab. It is drawn into the scene's transmittance
 * when the light buffers reach that slab. Points that no light reaches through the medium are
 * skipped. Points behind the last slab are drawn at the end, with the sample layers if the light
 * has any.
 */
class SliceReceivers
{
public:
  SliceReceivers();
  ~SliceReceivers();

  /// Sorts the surfaces into slabs of a sweep through these volumes.
  void Begin(const std::vector<std::unique_ptr<VolumeSlices>>& volumes, std::size_t sweepIndex);

  /**
   * Prepares a volume's programs. Start with the first volume. \a buffers are the sweep's light
   * buffers, whose textures must be active. Returns an error if a program cannot be compiled.
   */
  Error Prepare(vtkOpenGLRenderWindow* window, VolumeSlices& slices,
    const std::vector<SliceLightBuffer*>& buffers);

  /// Returns true if there are surfaces up to the end of \a slab that have not been drawn yet. The
  /// light buffers must not include the attenuation of \a slab yet. To include surfaces behind the
  /// last slab, pass the number of slabs.
  bool HasRemaining(int slab) const;
  /// Multiplies the light at the remaining surfaces up to the end of \a slab by a volume's
  /// transmittance. Returns the number of passes over layers.
  int Draw(vtkOpenGLRenderWindow* window, int slab, std::size_t volume);
  /// Skips the remaining surfaces up to the end of \a slab.
  void Pass(int slab) { this->Next = this->Starts[static_cast<std::size_t>(slab) + 1]; }

  void ReleaseGraphicsResources();

private:
  void Sort(const std::vector<std::unique_ptr<VolumeSlices>>& volumes);

  /// Programs of a volume for a light, and the light's tile in the scene's transmittance. Behind is
  /// set only for the first volume, if the light has layers.
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
  /// Index of the first point of each slab, of the first point behind the slabs, and number of
  /// points.
  std::vector<std::size_t> Starts;
  std::size_t Next = 0;
  vtkNew<vtkOpenGLBufferObject> Vertices;
};

}

#endif

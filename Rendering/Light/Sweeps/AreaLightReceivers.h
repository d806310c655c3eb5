// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_AreaLightReceivers_h
#define interlume_AreaLightReceivers_h

#include "Buffers/SlicePass.h"
#include "Common/Error.h"
#include "Plan/SlicePlan.h"

#include <cstddef>

class vtkOpenGLBufferObject;
class vtkOpenGLRenderWindow;

namespace interlume
{

class EmitterSampleLayers;
struct VolumeRenderState;

/**
 * @class   AreaLightReceivers
 * @brief   draws what an area light's layers leave at surfaces behind the slices
 *
 * The transmittance at x is sum_c w_c T_c(x_c), x_c the place in the layer of sample c of the ray
 * from there to x: so the penumbra of matter widens with the distance from it. Surfaces between
 * light and x let the share V = sum_c w_c V_c through, and what this is multiplied by is sum_c w_c
 * V_c T_c / V, so that matter and surfaces that hide the same part of a light do not hide it twice.
 */
class AreaLightReceivers
{
public:
  /// Compiles the program, for points in \a vertices. Returns an error if that fails.
  Error Prepare(vtkOpenGLRenderWindow* window, const VolumeRenderState& frame,
    const SlicePlan::ShadowedLight& light, const EmitterSampleLayers& layers,
    vtkOpenGLBufferObject* vertices);

  /// Draws so many points into the framebuffer that is bound, after the last batch is in the
  /// layers.
  void Draw(vtkOpenGLRenderWindow* window, const VolumeRenderState& frame,
    const SlicePlan::ShadowedLight& light, const EmitterSampleLayers& layers, std::size_t first,
    std::size_t count);

  void ReleaseGraphicsResources() { this->Pass.ReleaseGraphicsResources(); }

private:
  bool HasCasters = false;
  SlicePass Pass;
};

}

#endif

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
 * @brief   computes an area light's transmittance at surfaces behind all slices from its layers
 *
 * The transmittance at x is sum_c w_c T_c(x_c), where w_c is the weight of emitter sample c, T_c is
 * its layer, and x_c is the position at which the ray from the sample to x meets the layer.
 * Penumbras therefore widen with the distance from the medium. If surfaces between the light and x
 * transmit the fraction V_c of sample c's light, and therefore V = sum_c w_c V_c of the entire
 * light, the result is sum_c w_c V_c T_c / V. The shader of the surface multiplies it by V, so that
 * samples hidden by both the medium and a surface are attenuated only once.
 */
class AreaLightReceivers
{
public:
  /// Compiles the program that draws the points in \a vertices. Returns an error if that fails.
  Error Prepare(vtkOpenGLRenderWindow* window, const VolumeRenderState& frame,
    const SlicePlan::ShadowedLight& light, const EmitterSampleLayers& layers,
    vtkOpenGLBufferObject* vertices);

  /// Draws \a count points into the bound framebuffer. All batches must have been multiplied into
  /// the layers.
  void Draw(vtkOpenGLRenderWindow* window, const VolumeRenderState& frame,
    const SlicePlan::ShadowedLight& light, const EmitterSampleLayers& layers, std::size_t first,
    std::size_t count);

  void ReleaseGraphicsResources() { this->Pass.ReleaseGraphicsResources(); }

private:
  bool HasOccluders = false;
  SlicePass Pass;
};

}

#endif

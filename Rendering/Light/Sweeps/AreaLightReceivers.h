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
 * @brief   multiplies the layers of an area light into the transmittance at surfaces behind the
 * slices
 *
 * The transmittance at x is sum_c w_c T_c(x_c), where x_c is the position at which the ray from
 * sample c to x meets the sample's layer. Penumbras therefore widen with the distance from the
 * medium. Surfaces between the light and x let through the fraction V_c of the light of sample c,
 * and V = sum_c w_c V_c of the entire light. The result is then sum_c w_c V_c T_c / V, so that a
 * medium and a surface that hide the same part of a light do not hide it twice.
 */
class AreaLightReceivers
{
public:
  /// Compiles the program for points in \a vertices. Returns an error if that fails.
  Error Prepare(vtkOpenGLRenderWindow* window, const VolumeRenderState& frame,
    const SlicePlan::ShadowedLight& light, const EmitterSampleLayers& layers,
    vtkOpenGLBufferObject* vertices);

  /// Draws \a count points into the bound framebuffer. The last batch must have been multiplied
  /// into the layers.
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

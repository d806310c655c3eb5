// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SceneDepth_h
#define interlume_SceneDepth_h

#include "InterlumeSceneModule.h"

#include <array>
#include <vector>

class vtkProp;
class vtkRenderer;
class vtkTextureObject;

namespace interlume
{

/**
 * Reads the depth of the scene rendered so far, within the renderer's viewport of the current
 * framebuffer.
 *
 * Depth is 0 at the near plane and 1 at the far plane. Multisampled framebuffers are supported.
 */
namespace SceneDepth
{
/// Returns true if \a renderer has a visible prop that is not a volume, or preserves the depth of
/// another renderer. Ignores \a volume itself.
INTERLUMESCENE_EXPORT bool MayOcclude(vtkRenderer* renderer, vtkProp* volume);

/// Reads the depth, bottom row first. Sets \a size to the number of columns and rows. Returns false
/// on failure.
INTERLUMESCENE_EXPORT bool Read(
  vtkRenderer* renderer, std::vector<float>& depths, std::array<int, 2>& size);

/// Copies the depth to a floating-point texture of the size of the viewport, allocated if
/// necessary. Returns false if there is no depth buffer.
INTERLUMESCENE_EXPORT bool CopyTo(vtkRenderer* renderer, vtkTextureObject* texture);
}

}

#endif

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
 * Reads the depth of what is already in the image.
 *
 * The depth is that of the renderer's viewport in the framebuffer that is being drawn to, with one
 * or more samples per pixel: 0 at the near plane to 1 at the far plane.
 */
namespace SceneDepth
{
/// Returns true if \a renderer has a visible prop besides \a volume that is not a volume itself, or
/// keeps the depth of another renderer.
INTERLUMESCENE_EXPORT bool MayOcclude(vtkRenderer* renderer, vtkProp* volume);

/// Reads the depth row by row from below; \a size gets columns and rows. Returns false if it could
/// not be read.
INTERLUMESCENE_EXPORT bool Read(
  vtkRenderer* renderer, std::vector<float>& depths, std::array<int, 2>& size);

/// Copies the depth to a floating-point texture, which is made as large as the viewport. Returns
/// false if there is no depth.
INTERLUMESCENE_EXPORT bool CopyTo(vtkRenderer* renderer, vtkTextureObject* texture);
}

}

#endif

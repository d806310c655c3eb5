// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FloatTexture_h
#define interlume_FloatTexture_h

#include "InterlumeSceneModule.h"

#include "vtkType.h"

class vtkOpenGLRenderWindow;
class vtkTextureObject;

namespace interlume
{

/**
 * Allocates floating-point textures as render targets.
 */
namespace FloatTexture
{
/// Allocates \a texture with the requested size and format, with linear interpolation if \a
/// isSmooth. A texture that already fits keeps its contents. Returns the size in bytes, or 0 if
/// allocation fails.
INTERLUMESCENE_EXPORT vtkIdType Allocate(vtkOpenGLRenderWindow* window, vtkTextureObject* texture,
  int width, int height, int channels, bool isSmooth);

INTERLUMESCENE_EXPORT bool Fits(vtkTextureObject* texture, int width, int height);
}

}

#endif

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
 * Allocates floating-point textures to draw into.
 */
namespace FloatTexture
{
/// Allocates \a texture with the size and format requested; one that fits keeps its contents. It is
/// interpolated between its texels if \a isSmooth. Returns its bytes, or 0 without memory.
INTERLUMESCENE_EXPORT vtkIdType Allocate(vtkOpenGLRenderWindow* window, vtkTextureObject* texture,
  int width, int height, int channels, bool isSmooth);

INTERLUMESCENE_EXPORT bool Fits(vtkTextureObject* texture, int width, int height);
}

}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkFloatTarget_h
#define vtkFloatTarget_h

#include "InterlumeSceneModule.h" // for the export macro
#include "vtkType.h"              // for bytes

class vtkOpenGLRenderWindow;
class vtkTextureObject;

/**
 * @class   vtkFloatTarget
 * @brief   textures of floats to draw into
 */
class INTERLUMESCENE_EXPORT vtkFloatTarget
{
public:
  /**
   * Gives \a texture the size and format that are asked for; one that fits keeps its contents. It
   * is interpolated between its texels if \a isSmooth. Returns its bytes, or 0 where there is no
   * memory.
   */
  static vtkIdType Allocate(vtkOpenGLRenderWindow* window, vtkTextureObject* texture, int width,
    int height, int channels, bool isSmooth);

  static bool Fits(vtkTextureObject* texture, int width, int height);
};

#endif

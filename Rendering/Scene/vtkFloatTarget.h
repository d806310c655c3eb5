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
   * Makes \a texture fit, which keeps what it has where it does. Between its texels it is
   * interpolated if \a isSmooth. Returns its bytes, or 0 where there is no memory.
   */
  static vtkIdType Allocate(vtkOpenGLRenderWindow* window, vtkTextureObject* texture, int width,
    int height, int channels, bool isSmooth);

  static bool Fits(vtkTextureObject* texture, int width, int height);
};

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ScreenTextures_h
#define interlume_ScreenTextures_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <map>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkProjectiveLight;
class vtkTextureObject;
class vtkWindow;

namespace interlume
{

/**
 * @class   ScreenTextures
 * @brief   textures of the images of projective lights
 */
class ScreenTextures
{
public:
  ScreenTextures();
  ~ScreenTextures();

  /**
   * Returns the floating-point RGB texture of a light's image. It is created if \a light is new or
   * has changed; the uploaded size is then added to \a bytes.
   */
  vtkTextureObject* Get(vtkOpenGLRenderWindow* window, vtkProjectiveLight* light, vtkIdType& bytes);
  /// Releases the textures of lights that are not in \a lights.
  void Keep(const std::vector<vtkProjectiveLight*>& lights, vtkWindow* window);

private:
  struct Screen
  {
    vtkSmartPointer<vtkTextureObject> Texture;
    vtkMTimeType Time = 0;
  };

  std::map<vtkProjectiveLight*, Screen> Screens;
};

}

#endif

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
 * @brief   the images of projective lights on the graphics card
 */
class ScreenTextures
{
public:
  ScreenTextures();
  ~ScreenTextures();

  /**
   * Returns the texture of a light's image, RGB in floats, which is made where \a light is new or
   * has changed. \a bytes grows by what was sent.
   */
  vtkTextureObject* Get(vtkOpenGLRenderWindow* window, vtkProjectiveLight* light, vtkIdType& bytes);
  /// Frees the images of lights that are not among \a lights.
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

// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkPropSelection_h
#define vtkPropSelection_h

#include "InterlumeSceneModule.h" // for the export macro
#include "vtkImageQuad.h"         // for the quad

class vtkHardwareSelector;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

/**
 * @class   vtkPropSelection
 * @brief   shows a prop as a whole to a hardware selector, where its picture is not transparent
 */
class INTERLUMESCENE_EXPORT vtkPropSelection
{
public:
  /**
   * Draws the colour of the selector's pass over the viewport where \a picture, of RGBA, has
   * opacity: in passes that ask for the prop, its process or its only block. A null picture is
   * empty.
   */
  void Show(
    vtkHardwareSelector* selector, vtkOpenGLRenderWindow* window, vtkTextureObject* picture);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkImageQuad Quad;
};

#endif

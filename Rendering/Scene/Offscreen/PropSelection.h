// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PropSelection_h
#define interlume_PropSelection_h

#include "InterlumeSceneModule.h"
#include "Offscreen/ImageQuad.h"

class vtkHardwareSelector;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

namespace interlume
{

/**
 * @class   PropSelection
 * @brief   shows a prop as a whole to a hardware selector, where its picture is not transparent
 */
class INTERLUMESCENE_EXPORT PropSelection
{
public:
  /// Sets the color of the selector's pass for a prop as a whole. Returns false in passes that ask
  /// for its cells or points.
  static bool FindColor(vtkHardwareSelector* selector, float* color);

  /**
   * Draws that color over the viewport where \a picture, of RGBA, has opacity. A null picture is
   * empty.
   */
  void Show(
    vtkHardwareSelector* selector, vtkOpenGLRenderWindow* window, vtkTextureObject* picture);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  ImageQuad Quad;
};

}

#endif

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
 * @brief   draws a prop's hardware selection color wherever its image is not transparent
 */
class INTERLUMESCENE_EXPORT PropSelection
{
public:
  /// Sets \a color to the color that identifies the prop in the selector's current pass. Returns
  /// false in passes that select cells or points.
  static bool FindColor(vtkHardwareSelector* selector, float* color);

  /**
   * Draws the color from FindColor() where the RGBA \a image of the prop is not transparent. If \a
   * image is null, draws nothing.
   */
  void Show(vtkHardwareSelector* selector, vtkOpenGLRenderWindow* window, vtkTextureObject* image);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  ImageQuad Quad;
};

}

#endif

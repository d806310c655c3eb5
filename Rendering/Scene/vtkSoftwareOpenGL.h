// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSoftwareOpenGL_h
#define vtkSoftwareOpenGL_h

#include "InterlumeSceneModule.h" // for the export macro

class vtkOpenGLRenderWindow;

/**
 * @class   vtkSoftwareOpenGL
 * @brief   whether OpenGL runs on the processor instead of a graphics card
 */
class INTERLUMESCENE_EXPORT vtkSoftwareOpenGL
{
public:
  /**
   * Makes the window's context current, and returns whether its renderer is known by name to be
   * software. A renderer without a name counts as software.
   */
  static bool IsUsed(vtkOpenGLRenderWindow* window);
};

#endif

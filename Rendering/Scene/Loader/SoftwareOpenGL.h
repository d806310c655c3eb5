// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SoftwareOpenGL_h
#define interlume_SoftwareOpenGL_h

#include "InterlumeSceneModule.h"

class vtkOpenGLRenderWindow;

namespace interlume
{

/**
 * Detects software OpenGL.
 */
namespace SoftwareOpenGL
{
/// Makes the window's context current. Returns true if GL_RENDERER names a known software renderer
/// or is missing.
INTERLUMESCENE_EXPORT bool IsUsed(vtkOpenGLRenderWindow* window);
}

}

#endif

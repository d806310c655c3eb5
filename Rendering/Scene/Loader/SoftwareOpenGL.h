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
/// Makes the window's context current and returns true if the name of its OpenGL renderer is that
/// of known software, or is missing.
INTERLUMESCENE_EXPORT bool IsUsed(vtkOpenGLRenderWindow* window);
}

}

#endif

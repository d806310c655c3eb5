// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SoftwareOpenGL_h
#define interlume_SoftwareOpenGL_h

#include "InterlumeSceneModule.h"

class vtkOpenGLRenderWindow;

namespace interlume
{

/**
 * Finds whether OpenGL runs on the processor instead of a graphics card.
 */
namespace SoftwareOpenGL
{
/// Makes the window's context current, and returns whether its renderer is known by name to be
/// software. A renderer without a name counts as software.
INTERLUMESCENE_EXPORT bool IsUsed(vtkOpenGLRenderWindow* window);
}

}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_OpenGLFunctions_h
#define interlume_OpenGLFunctions_h

/**
 * @file
 * @brief OpenGL functions and constants, from the loader used by VTK
 *
 * Up to version 9.3, VTK loads OpenGL with GLEW (VTK::glew); from 9.4 on with glad (VTK::glad). A
 * module that includes this header must list both as optional dependencies. Do not include it in
 * public headers.
 */
#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

namespace interlume
{

/// Returns true if the current context supports OpenGL 3.2, which geometry shaders require.
inline bool HasOpenGL32()
{
#ifdef GLAD_GL_VERSION_3_2
  return GLAD_GL_VERSION_3_2 != 0;
#else
  return GLEW_VERSION_3_2 != 0;
#endif
}

/// Removes the errors of earlier commands, so that glGetError() returns those of the next commands.
inline void ClearOpenGLErrors()
{
  // Limited, because glGetError() always returns an error without a context.
  for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i)
  {
  }
}

}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_OpenGLFunctions_h
#define interlume_OpenGLFunctions_h

/**
 * @file
 * @brief OpenGL's functions and constants, by the loader that this VTK has
 *
 * VTK up to 9.3 loads OpenGL with GLEW, the module VTK::glew; from 9.4 on with glad, VTK::glad. A
 * module that includes this header names both among its optional dependencies. Its names are not
 * for public headers.
 */
#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

namespace interlume
{

/// Returns whether the context that is current has OpenGL 3.2, with which geometry shaders came.
inline bool HasOpenGL32()
{
#ifdef GLAD_GL_VERSION_3_2
  return GLAD_GL_VERSION_3_2 != 0;
#else
  return GLEW_VERSION_3_2 != 0;
#endif
}

}

#endif

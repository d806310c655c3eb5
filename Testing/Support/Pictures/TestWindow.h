// SPDX-License-Identifier: BSD-3-Clause
#ifndef TestWindow_h
#define TestWindow_h

#include "Loader/OpenGLFunctions.h"

#include "vtkOpenGLRenderWindow.h"

/**
 * What windows of tests need so that VTK's own warnings do not fail them.
 */
namespace reference
{
/// From 9.5 on VTK logs what a driver's compiler remarks about a shader, also about VTK's own, as a
/// warning; errors in shaders are told by other means.
inline void MuteShaderCompiler(vtkRenderWindow* window)
{
  vtkOpenGLRenderWindow::SafeDownCast(window)->Initialize();
  window->MakeCurrent();
  if (glDebugMessageControl)
  {
    glDebugMessageControl(
      GL_DEBUG_SOURCE_SHADER_COMPILER, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_FALSE);
  }
}

template <typename Window>
auto SetDepthBits(Window* window, int bits)
  -> decltype(window->SetRenderBufferTargetDepthSize(bits))
{
  window->SetRenderBufferTargetDepthSize(bits);
}

inline void SetDepthBits(void*, int) {}

/// VTK's depth peeling copies the depth of a window with several samples a pixel through a buffer
/// of 24 bits, which OpenGL allows from the same depth only; windows have 32 bits from VTK 9.4 on,
/// unless they are told otherwise.
inline void AllowPeelingOfSamples(vtkRenderWindow* window)
{
  SetDepthBits(vtkOpenGLRenderWindow::SafeDownCast(window), 24);
}
}

#endif

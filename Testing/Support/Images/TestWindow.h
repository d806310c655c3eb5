// SPDX-License-Identifier: BSD-3-Clause
#ifndef TestWindow_h
#define TestWindow_h

#include "Loader/OpenGLFunctions.h"

#include "vtkOpenGLRenderWindow.h"

/**
 * Settings of test windows that avoid VTK warnings, which would fail tests.
 */
namespace reference
{
/// Disables the messages of the driver's shader compiler. VTK 9.5 and later log them as warnings,
/// even for VTK's own shaders. Shader errors are reported separately.
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

/// Sets a 24-bit depth buffer. With multisampling, VTK's depth peeling copies depth through a
/// 24-bit buffer, which OpenGL only allows between equal formats. Since VTK 9.4, windows have a
/// 32-bit depth buffer by default.
inline void AllowMultisampledDepthPeeling(vtkRenderWindow* window)
{
  SetDepthBits(vtkOpenGLRenderWindow::SafeDownCast(window), 24);
}
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef ContextCount_h
#define ContextCount_h

#include "vtkType.h"

class vtkRenderWindow;

namespace gallery
{
/**
 * What an OpenGL context holds, asked of OpenGL itself, whoever made it.
 */
struct ContextCount
{
  /// Textures, render buffers and buffer objects, and the bytes of their storage.
  int Buffers = 0;
  vtkIdType Bytes = 0;
  /// Names, numbers and keywords in the sources of all shaders of all programs.
  vtkIdType Words = 0;
};

/// Counts what the window's context holds.
ContextCount CountContext(vtkRenderWindow* window);
}

#endif

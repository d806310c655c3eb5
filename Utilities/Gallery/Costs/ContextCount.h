// SPDX-License-Identifier: BSD-3-Clause
#ifndef ContextCount_h
#define ContextCount_h

#include "vtkType.h"

class vtkRenderWindow;

namespace gallery
{
/**
 * Resources of an OpenGL context. OpenGL is queried, so that the resources of all owners are
 * included.
 */
struct ContextCount
{
  /// Textures, render buffers and buffer objects, and the bytes of their storage.
  int Buffers = 0;
  vtkIdType Bytes = 0;
  /// Words (names, numbers and keywords) in the sources of all shaders of all programs.
  vtkIdType Words = 0;
};

/// Counts the resources of the window's context.
ContextCount CountContext(vtkRenderWindow* window);
}

#endif

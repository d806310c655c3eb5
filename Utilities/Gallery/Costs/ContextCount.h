// SPDX-License-Identifier: BSD-3-Clause
#ifndef ContextCount_h
#define ContextCount_h

#include "vtkType.h"

class vtkRenderWindow;

namespace gallery
{
/**
 * Resources of an OpenGL context. They are queried from OpenGL and thus include those created by
 * VTK.
 */
struct ContextCount
{
  /// Number of textures, renderbuffers and buffer objects, and their total size in bytes.
  int Buffers = 0;
  vtkIdType Bytes = 0;
  /// Number of words (identifiers, keywords and numbers) in the GLSL code of all shader programs.
  vtkIdType Words = 0;
};

/// Counts the resources of the window's context.
ContextCount CountContextResources(vtkRenderWindow* window);
}

#endif

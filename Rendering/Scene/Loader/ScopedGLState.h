// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ScopedGLState_h
#define interlume_ScopedGLState_h

#include "Loader/OpenGLFunctions.h"

#include "vtkOpenGLState.h"

namespace interlume
{

/**
 * @class   ScopedGLState
 * @brief   restores OpenGL's drawing state at the end of a scope
 */
struct ScopedGLState
{
  explicit ScopedGLState(vtkOpenGLState* state)
    : DepthTest(state, GL_DEPTH_TEST)
    , Blend(state, GL_BLEND)
    , Cull(state, GL_CULL_FACE)
    , Scissor(state, GL_SCISSOR_TEST)
    , ScissorBox(state)
    , DepthMask(state)
    , DepthFunc(state)
    , BlendFunction(state)
    , Viewport(state)
    , ClearColor(state)
  {
  }

private:
  vtkOpenGLState::ScopedglEnableDisable DepthTest;
  vtkOpenGLState::ScopedglEnableDisable Blend;
  vtkOpenGLState::ScopedglEnableDisable Cull;
  vtkOpenGLState::ScopedglEnableDisable Scissor;
  vtkOpenGLState::ScopedglScissor ScissorBox;
  vtkOpenGLState::ScopedglDepthMask DepthMask;
  vtkOpenGLState::ScopedglDepthFunc DepthFunc;
  vtkOpenGLState::ScopedglBlendFuncSeparate BlendFunction;
  vtkOpenGLState::ScopedglViewport Viewport;
  vtkOpenGLState::ScopedglClearColor ClearColor;
};

}

#endif

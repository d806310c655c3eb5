// SPDX-License-Identifier: BSD-3-Clause
#include "Translucent/LayerTarget.h"

#include "Loader/ScopedGLState.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureObject.h"

namespace interlume
{

LayerTarget::LayerTarget() = default;

LayerTarget::~LayerTarget() = default;

void LayerTarget::Draw(vtkOpenGLRenderWindow* window, vtkTextureObject* texture, Blends blend,
  const std::function<void()>& draw)
{
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  {
    const ScopedGLState scoped(state);
    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglEnable(GL_BLEND);
    state->vtkglEnable(GL_SCISSOR_TEST);
    state->vtkglDepthMask(GL_FALSE);
    this->Framebuffer->SetContext(window);
    this->Framebuffer->Bind();
    this->Framebuffer->AddColorAttachment(0, texture);
    this->Framebuffer->ActivateDrawBuffer(0);
    const auto width = static_cast<GLsizei>(texture->GetWidth());
    const auto height = static_cast<GLsizei>(texture->GetHeight());
    state->vtkglViewport(0, 0, width, height);
    state->vtkglScissor(0, 0, width, height);
    state->vtkglBlendEquation(blend == MINIMUM ? GL_MIN : GL_FUNC_ADD);
    if (blend == PRODUCT)
    {
      state->vtkglBlendFuncSeparate(GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_SRC_ALPHA);
    }
    else
    {
      state->vtkglBlendFuncSeparate(
        GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    }
    draw();
    state->vtkglBlendEquation(GL_FUNC_ADD);
    this->Framebuffer->RemoveColorAttachment(0);
  }
  state->PopFramebufferBindings();
}

bool LayerTarget::Upload(vtkOpenGLRenderWindow* window, vtkTextureObject* texture, int width,
  int height, int channels, const std::vector<float>& values)
{
  texture->SetContext(window);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  // Without this call, the texture would keep its previous format.
  texture->ResetFormatAndType();
  return texture->Create2DFromRaw(static_cast<unsigned int>(width),
    static_cast<unsigned int>(height), channels, VTK_FLOAT, const_cast<float*>(values.data()));
}

std::vector<float> LayerTarget::Read(vtkTextureObject* texture)
{
  std::vector<float> values(static_cast<std::size_t>(texture->GetWidth()) * texture->GetHeight());
  texture->Activate();
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RED, GL_FLOAT, values.data());
  texture->Deactivate();
  return values;
}

void LayerTarget::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Framebuffer->ReleaseGraphicsResources(window);
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowMaps/PropDepths.h"

#include "Loader/ScopedGLState.h"
#include "Offscreen/FloatTexture.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"

namespace interlume
{

PropDepths::PropDepths() = default;

PropDepths::~PropDepths() = default;

vtkIdType PropDepths::GetBytes() const
{
  return this->Texture->GetHandle() == 0
    ? 0
    : static_cast<vtkIdType>(sizeof(float)) * static_cast<vtkIdType>(this->Texture->GetWidth()) *
      static_cast<vtkIdType>(this->Texture->GetHeight());
}

bool PropDepths::Allocate(vtkOpenGLRenderWindow* window, int width, int height)
{
  this->Texture->SetContext(window);
  if (FloatTexture::Fits(this->Texture, width, height))
  {
    return true;
  }
  this->Texture->SetMinificationFilter(vtkTextureObject::Nearest);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
  return this->Texture->AllocateDepth(
    static_cast<unsigned int>(width), static_cast<unsigned int>(height), vtkTextureObject::Float32);
}

void PropDepths::Draw(
  vtkOpenGLRenderWindow* window, bool isCleared, const std::function<void()>& draw)
{
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  {
    const ScopedGLState scoped(state);
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDisable(GL_BLEND);
    state->vtkglEnable(GL_SCISSOR_TEST);
    state->vtkglDepthMask(GL_TRUE);
    state->vtkglDepthFunc(GL_LEQUAL);
    this->Framebuffer->SetContext(window);
    this->Framebuffer->Bind();
    this->Framebuffer->AddDepthAttachment(this->Texture);
    this->Framebuffer->DeactivateDrawBuffers();
    if (isCleared)
    {
      state->vtkglDisable(GL_SCISSOR_TEST);
      state->vtkglClearDepth(1.0);
      glClear(GL_DEPTH_BUFFER_BIT);
      state->vtkglEnable(GL_SCISSOR_TEST);
    }
    draw();
    this->Framebuffer->RemoveDepthAttachment();
  }
  state->PopFramebufferBindings();
}

void PropDepths::DrawProps(
  vtkRenderer* renderer, const std::vector<vtkProp*>& props, const std::array<int, 4>& part)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  window->GetState()->vtkglViewport(part[0], part[1], part[2], part[3]);
  window->GetState()->vtkglScissor(part[0], part[1], part[2], part[3]);
  for (vtkProp* prop : props)
  {
    prop->RenderOpaqueGeometry(renderer);
  }
}

void PropDepths::Read(vtkOpenGLRenderWindow* window, std::vector<float>& depths)
{
  window->MakeCurrent();
  depths.resize(static_cast<std::size_t>(this->Texture->GetWidth()) * this->Texture->GetHeight());
  this->Texture->Activate();
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
  this->Texture->Deactivate();
}

void PropDepths::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->Framebuffer->ReleaseGraphicsResources(window);
}

}

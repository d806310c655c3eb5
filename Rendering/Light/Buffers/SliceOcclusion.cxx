// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/SliceOcclusion.h"

#include "Loader/OpenGLFunctions.h"
#include "Offscreen/FloatTexture.h"
#include "Offscreen/ShaderFeatures.h"

#include "InterlumeSliceOcclusionFS.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

namespace interlume
{

SliceOcclusion::SliceOcclusion() = default;

SliceOcclusion::~SliceOcclusion() = default;

vtkIdType SliceOcclusion::Prepare(vtkOpenGLRenderWindow* window,
  vtkOpenGLFramebufferObject* framebuffer, int width, int height, bool hasDepths)
{
  this->Depth->SetContext(window);
  if (!FloatTexture::Fits(this->Depth, width, height))
  {
    this->Depth->AllocateDepth(static_cast<unsigned int>(width), static_cast<unsigned int>(height),
      hasDepths ? vtkTextureObject::Fixed24 : vtkTextureObject::Fixed16);
  }
  this->Framebuffer->SetContext(window);
  this->Framebuffer->Bind();
  this->Framebuffer->AddDepthAttachment(this->Depth);
  this->Framebuffer->DeactivateDrawBuffers();
  framebuffer->Bind();
  framebuffer->AddDepthAttachment(this->Depth);
  return static_cast<vtkIdType>(hasDepths ? 4 : 2) * width * height;
}

void SliceOcclusion::Clear(vtkOpenGLRenderWindow* window)
{
  vtkOpenGLState* state = window->GetState();
  state->vtkglClearDepth(1.0);
  state->vtkglDepthMask(GL_TRUE);
  glClear(GL_DEPTH_BUFFER_BIT);
  state->vtkglDepthMask(GL_FALSE);
}

void SliceOcclusion::Mark(
  vtkOpenGLRenderWindow* window, vtkTextureObject* buffer, Contents contents)
{
  std::string features = contents == OPACITY ? "OPACITY"
    : contents == TRANSMITTANCE              ? "TRANSMITTANCE"
                                             : "DEPTH";
  features += buffer->GetComponents() == 1 ? " CHANNELS=rrr" : " CHANNELS=rgb";
  if (!this->Quad || features != this->QuadFeatures)
  {
    this->QuadFeatures = features;
    const std::string source = ShaderFeatures::Insert(InterlumeSliceOcclusionFS, features);
    this->Quad = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, source.c_str(), nullptr);
  }
  else
  {
    window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
  }
  vtkOpenGLState* state = window->GetState();
  this->Framebuffer->Bind(GL_DRAW_FRAMEBUFFER);
  state->vtkglViewport(
    0, 0, static_cast<GLsizei>(buffer->GetWidth()), static_cast<GLsizei>(buffer->GetHeight()));
  // Do not deactivate an active light buffer: it keeps its texture unit for the whole sweep.
  const bool wasActive = buffer->GetTextureUnit() >= 0;
  buffer->Activate();
  this->Quad->Program->SetUniformi("slices", buffer->GetTextureUnit());
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_TRUE);
  this->Quad->Render();
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglDisable(GL_DEPTH_TEST);
  if (!wasActive)
  {
    buffer->Deactivate();
  }
}

void SliceOcclusion::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Depth->ReleaseGraphicsResources(window);
  this->Framebuffer->ReleaseGraphicsResources(window);
  if (this->Quad)
  {
    this->Quad->ReleaseGraphicsResources(window);
    this->Quad.reset();
  }
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/SliceOcclusion.h"

#include "Buffers/SlicePass.h"
#include "Loader/OpenGLFunctions.h"
#include "Offscreen/FloatTexture.h"
#include "Offscreen/ShaderFeatures.h"
#include "Space/ShaderUniforms.h"

#include "InterlumeSliceOcclusionFS.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
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

std::string SliceOcclusion::GetShaderSource(Contents contents, int channels)
{
  const std::string features = contents == OPACITY ? "OPACITY"
    : contents == TRANSMITTANCE                    ? "TRANSMITTANCE"
                                                   : "DEPTH";
  return ShaderFeatures::Insert(
    InterlumeSliceOcclusionFS, features + (channels == 1 ? " CHANNELS=rrr" : " CHANNELS=rgb"));
}

void SliceOcclusion::Mark(vtkOpenGLRenderWindow* window, vtkTextureObject* buffer,
  const glm::dmat4& clipFromUnit, SlicePass& pass, const std::vector<std::size_t>& starts, int slab)
{
  vtkOpenGLState* state = window->GetState();
  this->Framebuffer->Bind(GL_DRAW_FRAMEBUFFER);
  state->vtkglViewport(
    0, 0, static_cast<GLsizei>(buffer->GetWidth()), static_cast<GLsizei>(buffer->GetHeight()));
  // Do not deactivate an active light buffer: it keeps its texture unit for the whole sweep.
  const bool wasActive = buffer->GetTextureUnit() >= 0;
  buffer->Activate();
  window->GetShaderCache()->ReadyShaderProgram(pass.GetProgram());
  const ShaderUniforms uniforms(pass.GetProgram());
  uniforms.Set("slices", buffer->GetTextureUnit());
  uniforms.Set("clipFromUnit", clipFromUnit);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_TRUE);
  // The nearest depth for all fragments, without a depth in the shader: the depth test then skips
  // pixels that have been marked before.
  glEnable(GL_DEPTH_CLAMP);
  glDepthRange(0.0, 0.0);
  pass.Draw(window, starts, slab, 0.0);
  glDepthRange(0.0, 1.0);
  glDisable(GL_DEPTH_CLAMP);
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
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Offscreen/SceneDepth.h"

#include "Loader/OpenGLFunctions.h"
#include "Offscreen/FloatTexture.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"

#include <memory>

namespace interlume
{

namespace
{
// Returns the format of the current depth buffer. Copies between depth buffers require equal
// formats.
GLint GetDepthFormat()
{
  GLint type = GL_NONE;
  GLint name = 0;
  glGetFramebufferAttachmentParameteriv(
    GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
  GLint format = GL_DEPTH24_STENCIL8;
  if (type == GL_RENDERBUFFER || type == GL_TEXTURE)
  {
    glGetFramebufferAttachmentParameteriv(
      GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME, &name);
  }
  if (type == GL_RENDERBUFFER)
  {
    GLint before = 0;
    glGetIntegerv(GL_RENDERBUFFER_BINDING, &before);
    glBindRenderbuffer(GL_RENDERBUFFER, static_cast<GLuint>(name));
    glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_INTERNAL_FORMAT, &format);
    glBindRenderbuffer(GL_RENDERBUFFER, static_cast<GLuint>(before));
  }
  else if (type == GL_TEXTURE)
  {
    GLint before = 0;
    glGetIntegerv(GL_TEXTURE_BINDING_2D_MULTISAMPLE, &before);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, static_cast<GLuint>(name));
    glGetTexLevelParameteriv(GL_TEXTURE_2D_MULTISAMPLE, 0, GL_TEXTURE_INTERNAL_FORMAT, &format);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, static_cast<GLuint>(before));
  }
  return format;
}

bool HasStencil(GLint format)
{
  return format == GL_DEPTH24_STENCIL8 || format == GL_DEPTH32F_STENCIL8 ||
    format == GL_DEPTH_STENCIL;
}

// A copy of the depth buffer with one sample per pixel, bound for reading.
class SingleSampleCopy
{
public:
  SingleSampleCopy(int left, int bottom, int width, int height)
  {
    GLint target = 0;
    GLint renderbuffer = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
    glGetIntegerv(GL_RENDERBUFFER_BINDING, &renderbuffer);
    const GLint format = GetDepthFormat();
    glGenFramebuffers(1, &this->Framebuffer);
    glGenRenderbuffers(1, &this->Renderbuffer);
    glBindRenderbuffer(GL_RENDERBUFFER, this->Renderbuffer);
    glRenderbufferStorage(GL_RENDERBUFFER, static_cast<GLenum>(format), width, height);
    glBindRenderbuffer(GL_RENDERBUFFER, static_cast<GLuint>(renderbuffer));
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->Framebuffer);
    glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER,
      HasStencil(format) ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
      this->Renderbuffer);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(target));
    glBlitFramebuffer(left, bottom, left + width, bottom + height, 0, 0, width, height,
      GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(target));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, this->Framebuffer);
  }
  ~SingleSampleCopy()
  {
    glDeleteRenderbuffers(1, &this->Renderbuffer);
    glDeleteFramebuffers(1, &this->Framebuffer);
  }
  SingleSampleCopy(const SingleSampleCopy&) = delete;
  SingleSampleCopy& operator=(const SingleSampleCopy&) = delete;

private:
  GLuint Framebuffer = 0;
  GLuint Renderbuffer = 0;
};

// Calls read(left, bottom, width, height) with the depth buffer of the renderer's viewport bound
// for reading. Returns false if there is no depth buffer or reading fails.
template <typename Reader>
bool ReadDepth(vtkRenderer* renderer, const Reader& read)
{
  int width = 0;
  int height = 0;
  int left = 0;
  int bottom = 0;
  renderer->GetTiledSizeAndOrigin(&width, &height, &left, &bottom);
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkOpenGLState::ScopedglEnableDisable scissor(window->GetState(), GL_SCISSOR_TEST);
  window->GetState()->vtkglDisable(GL_SCISSOR_TEST);
  GLint readBefore = 0;
  GLint target = 0;
  GLint samples = 0;
  // VTK's selections can leave errors.
  ClearOpenGLErrors();
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &readBefore);
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
  glGetIntegerv(GL_SAMPLES, &samples);
  bool isRead = false;
  {
    std::unique_ptr<SingleSampleCopy> copy;
    if (samples > 0)
    {
      copy = std::make_unique<SingleSampleCopy>(left, bottom, width, height);
      left = 0;
      bottom = 0;
    }
    else
    {
      glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(target));
    }
    GLint type = GL_NONE;
    glGetFramebufferAttachmentParameteriv(GL_READ_FRAMEBUFFER,
      target == 0 && !copy ? GL_DEPTH : GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE,
      &type);
    if (type != GL_NONE)
    {
      read(left, bottom, width, height);
      isRead = true;
    }
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(readBefore));
  }
  return isRead && glGetError() == GL_NO_ERROR;
}
}

bool SceneDepth::MayOcclude(vtkRenderer* renderer, vtkProp* volume)
{
  // Depth preserved from another renderer can occlude the volume too.
  if (renderer->GetPreserveDepthBuffer())
  {
    return true;
  }
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    if (prop != volume && prop->GetVisibility() && !prop->IsA("vtkVolume"))
    {
      return true;
    }
  }
  return false;
}

bool SceneDepth::CopyTo(vtkRenderer* renderer, vtkTextureObject* texture)
{
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  if (!FloatTexture::Fits(texture, size[0], size[1]))
  {
    texture->AllocateDepth(static_cast<unsigned int>(size[0]), static_cast<unsigned int>(size[1]),
      vtkTextureObject::Float32);
  }
  // Activate the texture before binding the depth buffer. VTK 9.2 and later report inconsistent
  // state otherwise.
  texture->Activate();
  const bool isRead = ReadDepth(renderer,
    [](int left, int bottom, int width, int height)
    { glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, left, bottom, width, height); });
  texture->Deactivate();
  return isRead;
}

bool SceneDepth::Read(vtkRenderer* renderer, std::vector<float>& depths, std::array<int, 2>& size)
{
  return ReadDepth(renderer,
    [&](int left, int bottom, int width, int height)
    {
      size = { { width, height } };
      depths.resize(static_cast<std::size_t>(width) * height);
      glReadPixels(left, bottom, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
    });
}

}

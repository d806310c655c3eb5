#include "vtkTextureBuffer.h"

#include "vtkOpenGLFunctions.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureUnitManager.h"

//------------------------------------------------------------------------------
vtkIdType vtkTextureBuffer::Upload(Formats format, const void* data, std::size_t bytes)
{
  if (!this->Buffer)
  {
    glGenBuffers(1, &this->Buffer);
    glGenTextures(1, &this->Texture);
  }
  // A buffer of no bytes cannot be sampled.
  const std::size_t size = bytes ? bytes : 16;
  glBindBuffer(GL_TEXTURE_BUFFER, this->Buffer);
  glBufferData(
    GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(size), bytes ? data : nullptr, GL_STATIC_DRAW);
  static const GLenum internal[] = { GL_R32F, GL_RGBA32F, GL_R32I, GL_RGBA32UI };
  glBindTexture(GL_TEXTURE_BUFFER, this->Texture);
  glTexBuffer(GL_TEXTURE_BUFFER, internal[format], this->Buffer);
  glBindTexture(GL_TEXTURE_BUFFER, 0);
  glBindBuffer(GL_TEXTURE_BUFFER, 0);
  this->Bytes = size;
  return static_cast<vtkIdType>(bytes);
}

//------------------------------------------------------------------------------
void vtkTextureBuffer::Activate(
  vtkOpenGLRenderWindow* window, vtkShaderProgram* program, const char* name)
{
  this->Unit = window->GetState()->GetTextureUnitManager()->Allocate();
  window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + this->Unit);
  glBindTexture(GL_TEXTURE_BUFFER, this->Texture);
  program->SetUniformi(name, this->Unit);
}

//------------------------------------------------------------------------------
void vtkTextureBuffer::Deactivate(vtkOpenGLRenderWindow* window)
{
  window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + this->Unit);
  glBindTexture(GL_TEXTURE_BUFFER, 0);
  window->GetState()->GetTextureUnitManager()->Free(this->Unit);
  this->Unit = -1;
}

//------------------------------------------------------------------------------
void vtkTextureBuffer::Release()
{
  if (this->Buffer)
  {
    glDeleteTextures(1, &this->Texture);
    glDeleteBuffers(1, &this->Buffer);
  }
  this->Buffer = 0;
  this->Texture = 0;
  this->Bytes = 0;
}

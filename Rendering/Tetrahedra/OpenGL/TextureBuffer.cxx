// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/TextureBuffer.h"

#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

namespace interlume
{

TextureBuffer::TextureBuffer() = default;

TextureBuffer::~TextureBuffer()
{
  vtkOpenGLRenderWindow* window = this->Texture->GetContext();
  if (this->IsAllocated() && window)
  {
    window->MakeCurrent();
    this->Release(window);
  }
}

vtkIdType TextureBuffer::Upload(
  vtkOpenGLRenderWindow* window, Formats format, const void* data, std::size_t bytes)
{
  static const int types[] = { VTK_FLOAT, VTK_FLOAT, VTK_INT, VTK_UNSIGNED_INT, VTK_UNSIGNED_INT };
  static const int components[] = { 1, 4, 1, 1, 4 };
  // An empty buffer cannot be sampled, so upload a few zeros instead of an empty array.
  static const char nothing[16] = {};
  this->Bytes = bytes ? bytes : sizeof(nothing);
  this->Buffer->Upload(bytes ? static_cast<const char*>(data) : nothing, this->Bytes,
    vtkOpenGLBufferObject::TextureBuffer);
  this->Buffer->Release();
  this->Texture->SetContext(window);
  if (types[format] != VTK_FLOAT)
  {
    // This call selects an integer format, which CreateTextureBuffer() does not do by default.
    this->Texture->GetInternalFormat(types[format], components[format], true);
  }
  this->Texture->CreateTextureBuffer(
    static_cast<unsigned int>(this->Bytes / (4 * components[format])), components[format],
    types[format], this->Buffer);
  return static_cast<vtkIdType>(bytes);
}

void TextureBuffer::Activate(vtkShaderProgram* program, const char* name)
{
  this->Texture->Activate();
  program->SetUniformi(name, this->Texture->GetTextureUnit());
}

void TextureBuffer::Deactivate()
{
  this->Texture->Deactivate();
}

void TextureBuffer::Release(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->Buffer->ReleaseGraphicsResources();
  this->Bytes = 0;
}

}

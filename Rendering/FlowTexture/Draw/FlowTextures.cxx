// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/FlowTextures.h"

#include "Loader/OpenGLFunctions.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace interlume
{

namespace
{
/// Creates the texture object. Recreates it if its number of dimensions has changed, because the
/// target of a texture object cannot change.
void MakeObject(
  vtkSmartPointer<vtkTextureObject>& object, unsigned int target, vtkOpenGLRenderWindow* window)
{
  if (object && object->GetTarget() != target)
  {
    object->ReleaseGraphicsResources(window);
    object = nullptr;
  }
  if (!object)
  {
    object = vtkSmartPointer<vtkTextureObject>::New();
  }
}
}

void FlowTextures::Begin(vtkOpenGLRenderWindow* window)
{
  this->Window = window;
  this->UploadedBytes = 0;
  this->FirstError = {};
  for (auto& [name, texture] : this->Textures)
  {
    texture.IsUsed = false;
  }
}

Error FlowTextures::Finish()
{
  for (auto it = this->Textures.begin(); it != this->Textures.end();)
  {
    if (it->second.IsUsed)
    {
      ++it;
      continue;
    }
    if (it->second.Object)
    {
      it->second.Object->ReleaseGraphicsResources(this->Window);
    }
    it = this->Textures.erase(it);
  }
  return this->FirstError;
}

void FlowTextures::Update(const std::string& name, const std::string& title, bool isVolume,
  const Stamp& stamp, const std::function<Source()>& make, int& count)
{
  if (this->FirstError)
  {
    return;
  }
  Texture& texture = this->Textures[name];
  texture.IsUsed = true;
  if (texture.Object && texture.SourceStamp == stamp)
  {
    return;
  }
  texture.SourceStamp = {};
  this->FirstError = this->Upload(isVolume, texture, make()).Within(title + " ");
  if (this->FirstError)
  {
    return;
  }
  texture.SourceStamp = stamp;
  ++count;
  this->UploadedBytes += texture.Bytes;
}

Error FlowTextures::Upload(bool isVolume, Texture& texture, const Source& source)
{
  if (source.Error)
  {
    return source.Error;
  }
  GLint limit = 0;
  glGetIntegerv(isVolume ? GL_MAX_3D_TEXTURE_SIZE : GL_MAX_TEXTURE_SIZE, &limit);
  const int largest = *std::max_element(source.Size.begin(), source.Size.end());
  if (largest > limit)
  {
    return { "has " + std::to_string(largest) +
        " texels along an axis, but the GPU supports at most " + std::to_string(limit) +
        ". Use a smaller image.",
      ErrorCode::OpenGL };
  }
  MakeObject(texture.Object, isVolume ? GL_TEXTURE_3D : GL_TEXTURE_2D, this->Window);
  vtkTextureObject* object = texture.Object;
  object->SetContext(this->Window);
  const int filter = source.IsSmooth ? vtkTextureObject::Linear : vtkTextureObject::Nearest;
  object->SetMagnificationFilter(filter);
  object->SetMinificationFilter(
    source.HasLevels ? static_cast<int>(vtkTextureObject::LinearMipmapLinear) : filter);
  object->SetGenerateMipmap(source.HasLevels);
  const int wrap = source.IsRepeated ? vtkTextureObject::Repeat : vtkTextureObject::ClampToEdge;
  object->SetWrapS(wrap);
  object->SetWrapT(wrap);
  object->SetWrapR(wrap);
  // Without this reset, the texture keeps the format of its previous contents.
  object->ResetFormatAndType();
  ClearOpenGLErrors();
  const auto columns = static_cast<unsigned int>(source.Size[0]);
  const auto rows = static_cast<unsigned int>(source.Size[1]);
  void* values = const_cast<void*>(source.Values);
  const bool isMade = isVolume
    ? object->Create3DFromRaw(columns, rows, static_cast<unsigned int>(source.Size[2]),
        source.Components, source.Type, values)
    : object->Create2DFromRaw(columns, rows, source.Components, source.Type, values);
  const vtkIdType texel = source.Components *
    static_cast<vtkIdType>(source.Type == VTK_FLOAT ? sizeof(float) : sizeof(unsigned short));
  texture.Bytes = texel * source.Size[0] * source.Size[1] * source.Size[2];
  if (!isMade || glGetError() != GL_NO_ERROR)
  {
    object->ReleaseGraphicsResources(this->Window);
    texture.Object = nullptr;
    return { "requires " + std::to_string(texture.Bytes) +
        " bytes, but the GPU is out of memory. Use a smaller image.",
      ErrorCode::OutOfMemory };
  }
  return {};
}

vtkIdType FlowTextures::GetBytes() const
{
  vtkIdType bytes = 0;
  for (const auto& [name, texture] : this->Textures)
  {
    bytes += texture.Bytes;
  }
  return bytes;
}

void FlowTextures::Activate(vtkShaderProgram* program)
{
  for (auto& [name, texture] : this->Textures)
  {
    if (texture.Object && program->IsUniformUsed(name.c_str()))
    {
      texture.Object->Activate();
      program->SetUniformi(name.c_str(), texture.Object->GetTextureUnit());
      this->Active.push_back(texture.Object);
    }
  }
}

void FlowTextures::Deactivate()
{
  for (vtkTextureObject* texture : this->Active)
  {
    texture->Deactivate();
  }
  this->Active.clear();
}

void FlowTextures::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto& [name, texture] : this->Textures)
  {
    if (texture.Object)
    {
      texture.Object->ReleaseGraphicsResources(window);
    }
  }
  this->Textures.clear();
}

}

// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Costs/ContextCount.h"

#include "Loader/OpenGLFunctions.h"

#include "vtkRenderWindow.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <vector>

namespace gallery
{
namespace
{
/// Upper bound on the names of OpenGL objects. Drivers number objects from 1 and reuse freed names
/// first.
constexpr GLuint MAXIMUM_NAME = 20000;

struct Target
{
  GLenum Name;
  GLenum Binding;
};
constexpr std::array<Target, 5> TARGETS = { { { GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D },
  { GL_TEXTURE_3D, GL_TEXTURE_BINDING_3D }, { GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY },
  { GL_TEXTURE_1D, GL_TEXTURE_BINDING_1D }, { GL_TEXTURE_BUFFER, GL_TEXTURE_BINDING_BUFFER } } };

void ClearErrors()
{
  while (glGetError() != GL_NO_ERROR)
  {
  }
}

std::array<GLint, 3> GetLevelSize(GLenum target, GLint level)
{
  std::array<GLint, 3> size{};
  glGetTexLevelParameteriv(target, level, GL_TEXTURE_WIDTH, &size[0]);
  glGetTexLevelParameteriv(target, level, GL_TEXTURE_HEIGHT, &size[1]);
  glGetTexLevelParameteriv(target, level, GL_TEXTURE_DEPTH, &size[2]);
  return size;
}

vtkIdType GetLevelBytes(GLenum target, GLint level)
{
  const std::array<GLint, 3> size = GetLevelSize(target, level);
  vtkIdType bits = 0;
  for (const GLenum channel : { GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_BLUE_SIZE,
         GL_TEXTURE_ALPHA_SIZE, GL_TEXTURE_DEPTH_SIZE, GL_TEXTURE_STENCIL_SIZE })
  {
    GLint of = 0;
    glGetTexLevelParameteriv(target, level, channel, &of);
    bits += of;
  }
  return bits * size[0] * size[1] * size[2] / 8;
}

/// Returns the number of levels in a full mipmap chain of the bound texture. Higher levels must not
/// be queried, since drivers report an error for levels beyond their limit.
GLint GetNumberOfLevels(GLenum target)
{
  std::array<GLint, 3> size = GetLevelSize(target, 0);
  if (target != GL_TEXTURE_3D)
  {
    size[2] = 0; // number of layers of an array texture, not an edge length
  }
  GLint levels = 0;
  for (GLint side = *std::max_element(size.begin(), size.end()); side > 0; side /= 2)
  {
    ++levels;
  }
  return levels;
}

/// Returns the size of a texture in bytes, or 0 for a buffer texture, whose storage is counted as a
/// buffer object.
vtkIdType GetTextureBytes(GLuint texture)
{
  for (const Target& target : TARGETS)
  {
    GLint bound = 0;
    glGetIntegerv(target.Binding, &bound);
    ClearErrors();
    glBindTexture(target.Name, texture);
    if (glGetError() != GL_NO_ERROR)
    {
      continue;
    }
    vtkIdType bytes = 0;
    const GLint levels = target.Name == GL_TEXTURE_BUFFER ? 0 : GetNumberOfLevels(target.Name);
    for (GLint level = 0; level < levels; ++level)
    {
      bytes += GetLevelBytes(target.Name, level);
    }
    glBindTexture(target.Name, static_cast<GLuint>(bound));
    ClearErrors();
    return bytes;
  }
  return 0;
}

vtkIdType GetBufferBytes(GLuint buffer)
{
  GLint bound = 0;
  glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &bound);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  GLint bytes = 0;
  glGetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_SIZE, &bytes);
  glBindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(bound));
  return bytes;
}

vtkIdType GetRenderBufferBytes(GLuint buffer)
{
  GLint bound = 0;
  glGetIntegerv(GL_RENDERBUFFER_BINDING, &bound);
  glBindRenderbuffer(GL_RENDERBUFFER, buffer);
  vtkIdType bits = 0;
  for (const GLenum channel :
    { GL_RENDERBUFFER_RED_SIZE, GL_RENDERBUFFER_GREEN_SIZE, GL_RENDERBUFFER_BLUE_SIZE,
      GL_RENDERBUFFER_ALPHA_SIZE, GL_RENDERBUFFER_DEPTH_SIZE, GL_RENDERBUFFER_STENCIL_SIZE })
  {
    GLint of = 0;
    glGetRenderbufferParameteriv(GL_RENDERBUFFER, channel, &of);
    bits += of;
  }
  GLint size[2] = { 0, 0 };
  glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_WIDTH, &size[0]);
  glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_HEIGHT, &size[1]);
  glBindRenderbuffer(GL_RENDERBUFFER, static_cast<GLuint>(bound));
  return bits * size[0] * size[1] / 8;
}

vtkIdType CountWords(const std::string& text)
{
  vtkIdType words = 0;
  bool isInWord = false;
  for (const char letter : text)
  {
    const bool isOfWord = std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_';
    words += isOfWord && !isInWord ? 1 : 0;
    isInWord = isOfWord;
  }
  return words;
}

vtkIdType CountProgramWords(GLuint program)
{
  std::array<GLuint, 8> shaders{};
  GLsizei number = 0;
  glGetAttachedShaders(program, static_cast<GLsizei>(shaders.size()), &number, shaders.data());
  vtkIdType words = 0;
  for (GLsizei i = 0; i < number; ++i)
  {
    GLint length = 0;
    glGetShaderiv(shaders[i], GL_SHADER_SOURCE_LENGTH, &length);
    std::vector<char> source(static_cast<std::size_t>(length) + 1, '\0');
    glGetShaderSource(shaders[i], length + 1, nullptr, source.data());
    words += CountWords(source.data());
  }
  return words;
}
}

ContextCount CountContextResources(vtkRenderWindow* window)
{
  window->MakeCurrent();
  // Debug output is disabled, since GetTextureBytes() tries to bind a texture to all targets, and
  // errors from wrong targets are expected.
  const bool reports = glIsEnabled(GL_DEBUG_OUTPUT) == GL_TRUE;
  glDisable(GL_DEBUG_OUTPUT);
  ContextCount count;
  for (GLuint name = 1; name < MAXIMUM_NAME; ++name)
  {
    const bool isTexture = glIsTexture(name) == GL_TRUE;
    const bool isBuffer = glIsBuffer(name) == GL_TRUE;
    const bool isRenderBuffer = glIsRenderbuffer(name) == GL_TRUE;
    count.Buffers += (isTexture ? 1 : 0) + (isBuffer ? 1 : 0) + (isRenderBuffer ? 1 : 0);
    count.Bytes += isTexture ? GetTextureBytes(name) : 0;
    count.Bytes += isBuffer ? GetBufferBytes(name) : 0;
    count.Bytes += isRenderBuffer ? GetRenderBufferBytes(name) : 0;
    count.Words += glIsProgram(name) == GL_TRUE ? CountProgramWords(name) : 0;
  }
  if (reports)
  {
    glEnable(GL_DEBUG_OUTPUT);
  }
  ClearErrors();
  return count;
}
}

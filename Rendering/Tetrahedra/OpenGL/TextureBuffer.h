// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TextureBuffer_h
#define interlume_TextureBuffer_h

#include "vtkNew.h"
#include "vtkType.h"

#include <cstddef>

class vtkOpenGLBufferObject;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace interlume
{

/**
 * @class   TextureBuffer
 * @brief   an array that shaders read by index
 */
class TextureBuffer
{
public:
  enum Formats
  {
    FLOAT,
    FLOAT4,
    INT,
    UINT,
    UINT4
  };

  TextureBuffer();
  ~TextureBuffer();
  TextureBuffer(const TextureBuffer&) = delete;
  TextureBuffer& operator=(const TextureBuffer&) = delete;

  /**
   * Replaces the array. Returns the number of bytes uploaded.
   */
  vtkIdType Upload(
    vtkOpenGLRenderWindow* window, Formats format, const void* data, std::size_t bytes);

  /**
   * Binds the array to a texture unit and sets the sampler uniform \a name. Deactivate() frees the
   * unit.
   */
  void Activate(vtkShaderProgram* program, const char* name);
  void Deactivate();

  /// Frees the array. The OpenGL context must be current; the destructor makes it current itself.
  void Release(vtkWindow* window);

  std::size_t GetBytes() const { return this->Bytes; }
  bool IsAllocated() const { return this->Bytes != 0; }

private:
  vtkNew<vtkOpenGLBufferObject> Buffer;
  vtkNew<vtkTextureObject> Texture;
  std::size_t Bytes = 0;
};

}

#endif

#ifndef vtkTextureBuffer_h
#define vtkTextureBuffer_h

#include "vtkType.h"

#include <cstddef>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

/**
 * @class   vtkTextureBuffer
 * @brief   an array that shaders read by index
 */
class vtkTextureBuffer
{
public:
  enum Formats
  {
    FLOAT,
    FLOAT4,
    INT,
    UINT4
  };

  vtkTextureBuffer() = default;
  ~vtkTextureBuffer() = default;
  vtkTextureBuffer(const vtkTextureBuffer&) = delete;
  vtkTextureBuffer& operator=(const vtkTextureBuffer&) = delete;

  /**
   * Replaces all of it. Returns the bytes sent.
   */
  vtkIdType Upload(Formats format, const void* data, std::size_t bytes);

  /**
   * Binds it to a texture unit and gives that to the sampler \a name; Deactivate() frees the unit.
   */
  void Activate(vtkOpenGLRenderWindow* window, vtkShaderProgram* program, const char* name);
  void Deactivate(vtkOpenGLRenderWindow* window);

  /// With the context current.
  void Release();

  std::size_t GetBytes() const { return this->Bytes; }
  bool IsAllocated() const { return this->Buffer != 0; }

private:
  unsigned int Buffer = 0;
  unsigned int Texture = 0;
  std::size_t Bytes = 0;
  int Unit = -1;
};

#endif

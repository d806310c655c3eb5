// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PropDepths_h
#define interlume_PropDepths_h

#include "vtkNew.h"
#include "vtkType.h"

#include <array>
#include <functional>
#include <vector>

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkRenderer;
class vtkTextureObject;
class vtkWindow;

namespace interlume
{

/**
 * @class   PropDepths
 * @brief   depth of opaque props in a floating-point texture
 */
class PropDepths
{
public:
  PropDepths();
  ~PropDepths();

  vtkTextureObject* GetTexture() const { return this->Texture; }
  vtkIdType GetBytes() const;

  /// Resizes the texture if necessary. Returns false if the GPU runs out of memory.
  bool Allocate(vtkOpenGLRenderWindow* window, int width, int height);

  /**
   * Calls \a draw with the texture bound as the depth buffer, without color buffers. Clears the
   * texture first if \a isCleared is true. Restores the OpenGL state.
   */
  void Draw(vtkOpenGLRenderWindow* window, bool isCleared, const std::function<void()>& draw);

  /// Draws the opaque geometry of props with the renderer's camera, into the viewport \a part
  /// (left, bottom, width, height) of the bound framebuffer.
  static void DrawProps(
    vtkRenderer* renderer, const std::vector<vtkProp*>& props, const std::array<int, 4>& part);

  /// Reads the texture in row-major order, starting with the bottom row.
  void Read(vtkOpenGLRenderWindow* window, std::vector<float>& depths);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkNew<vtkTextureObject> Texture;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
};

}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LayerTarget_h
#define interlume_LayerTarget_h

#include "vtkNew.h"

#include <functional>
#include <string>
#include <vector>

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

namespace interlume
{

/**
 * @class   LayerTarget
 * @brief   framebuffer for drawing translucent surfaces into floating-point textures
 */
class LayerTarget
{
public:
  enum Blends
  {
    /// Minimum of all values.
    MINIMUM,
    /// Product of all values.
    PRODUCT,
    /// Alpha blending of colors over the target, whose colors are premultiplied.
    OVER
  };

  LayerTarget();
  ~LayerTarget();

  /// Calls \a draw with the texture bound as the framebuffer. Restores the OpenGL state.
  void Draw(vtkOpenGLRenderWindow* window, vtkTextureObject* texture, Blends blend,
    const std::function<void()>& draw);

  ///@{
  /// Creates a texture with one or two channels from values in rows from the bottom. Returns false
  /// if the GPU runs out of memory.
  static bool Upload(vtkOpenGLRenderWindow* window, vtkTextureObject* texture, int width,
    int height, int channels, const std::vector<float>& values);
  /// Returns the texels of a texture with one channel.
  static std::vector<float> Read(vtkTextureObject* texture);
  ///@}

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
};

}

#endif

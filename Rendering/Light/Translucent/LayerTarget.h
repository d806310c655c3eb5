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
 * @brief   a framebuffer for textures of floats that translucent surfaces are drawn into
 */
class LayerTarget
{
public:
  enum Blends
  {
    /// The least of all.
    LEAST,
    /// The product of all.
    PRODUCT,
    /// Colours over each other, with opacity; the target's are multiplied by it.
    OVER
  };

  LayerTarget();
  ~LayerTarget();

  /// Calls \a draw with the texture bound. The state of OpenGL is then as before.
  void Draw(vtkOpenGLRenderWindow* window, vtkTextureObject* texture, Blends blend,
    const std::function<void()>& draw);

  ///@{
  /// Makes a texture of one value a texel, or of two, of these values, row by row from below.
  /// Returns false where the card has no memory.
  static bool Upload(vtkOpenGLRenderWindow* window, vtkTextureObject* texture, int width,
    int height, int channels, const std::vector<float>& values);
  /// Reads a texture of one value a texel.
  static std::vector<float> Read(vtkTextureObject* texture);
  ///@}

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
};

}

#endif

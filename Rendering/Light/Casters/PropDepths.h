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
 * @brief   the depth of opaque props in a texture of floats
 */
class PropDepths
{
public:
  PropDepths();
  ~PropDepths();

  vtkTextureObject* GetTexture() const { return this->Texture; }
  vtkIdType GetBytes() const;

  /// Makes the texture of that size, unless it is. Returns false where the card has no memory.
  bool Allocate(vtkOpenGLRenderWindow* window, int width, int height);

  /**
   * Calls \a draw with the texture bound as the depth buffer, without colours, cleared if \a
   * isCleared. The state of OpenGL is then as before.
   */
  void Draw(vtkOpenGLRenderWindow* window, bool isCleared, const std::function<void()>& draw);

  /// Draws the opaque geometry of props into the part \a left, \a bottom, \a width, \a height of
  /// the framebuffer that is bound, as the renderer's camera sees it.
  static void DrawProps(
    vtkRenderer* renderer, const std::vector<vtkProp*>& props, const std::array<int, 4>& part);

  /// Reads the texture row by row from below.
  void Read(vtkOpenGLRenderWindow* window, std::vector<float>& depths);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkNew<vtkTextureObject> Texture;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
};

}

#endif

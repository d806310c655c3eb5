// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_EyeLayers_h
#define interlume_EyeLayers_h

#include "Offscreen/ImageQuad.h"
#include "Translucent/DepthLayers.h"

#include "vtkNew.h"

#include <functional>

namespace interlume
{

/**
 * @class   EyeLayers
 * @brief   the picture of translucent surfaces and of volumes between them, in order
 *
 * The layers of surfaces that the eye sees cut each pixel's line of sight into segments: segment 0
 * is before the first layer, the last one behind all. What is in them is drawn from back to front
 * into one picture of floats, of colour times opacity, and opacity.
 */
class EyeLayers
{
public:
  EyeLayers();
  ~EyeLayers();

  DepthLayers& GetDepths() { return this->Depths; }
  std::size_t GetNumber() const { return this->Depths.Get().size(); }

  /// Makes an empty picture. Returns false where the card has no memory.
  bool Clear(vtkOpenGLRenderWindow* window, int width, int height);
  /// Draws the surfaces of a layer, which \a draw draws, over the picture.
  void Shade(vtkOpenGLRenderWindow* window, std::size_t layer, LayerShader& shader,
    const std::function<void()>& draw);
  /// Calls \a draw, which draws over the framebuffer that is bound, for the picture.
  void Lay(vtkOpenGLRenderWindow* window, const std::function<void()>& draw);

  /// Lays the picture over the viewport, for the first time since Clear.
  void Show(vtkOpenGLRenderWindow* window);

  vtkIdType GetBytes() const;

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  DepthLayers Depths;
  LayerTarget Target;
  vtkNew<vtkTextureObject> Picture;
  ImageQuad Quad;
  bool IsShown = true;
};

}

#endif

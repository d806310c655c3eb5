// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CameraLayers_h
#define interlume_CameraLayers_h

#include "Offscreen/ImageQuad.h"
#include "Translucent/DepthLayers.h"

#include "vtkNew.h"

#include <functional>

namespace interlume
{

/**
 * @class   CameraLayers
 * @brief   rendered image of translucent surfaces and the volumes between them, in depth order
 *
 * The translucent layers that the camera sees divide each view ray into segments. Segment 0 is in
 * front of the first layer, and the last segment behind all layers. Segments and layers are
 * composited from back to front into one floating-point image of premultiplied color and opacity.
 */
class CameraLayers
{
public:
  CameraLayers();
  ~CameraLayers();

  DepthLayers& GetDepths() { return this->Depths; }
  std::size_t GetNumber() const { return this->Depths.Get().size(); }

  /// Creates an empty image. Returns false if the GPU runs out of memory.
  bool Clear(vtkOpenGLRenderWindow* window, int width, int height);
  /// Composites a layer over the image. \a draw draws its surfaces.
  void Shade(vtkOpenGLRenderWindow* window, std::size_t layer, LayerShader& shader,
    const std::function<void()>& draw);
  /// Calls \a draw, which composites over the bound framebuffer, with the image as the framebuffer.
  void Composite(vtkOpenGLRenderWindow* window, const std::function<void()>& draw);

  /// Composites the image over the viewport. Call it only once after each Clear.
  void Show(vtkOpenGLRenderWindow* window);

  vtkIdType GetBytes() const;

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  DepthLayers Depths;
  LayerTarget Target;
  vtkNew<vtkTextureObject> Image;
  ImageQuad Quad;
  bool IsShown = true;
};

}

#endif

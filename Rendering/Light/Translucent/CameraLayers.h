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
 * @brief   image of translucent surfaces and the volumes between them, composited in depth order
 *
 * The translucent layers that the camera sees divide each view ray into segments. Segment 0 is in
 * front of the first layer, and the last segment is behind all layers. Segments and layers are
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
  /// Composites a layer over the image. \a draw draws all translucent surfaces.
  void Shade(vtkOpenGLRenderWindow* window, std::size_t layer, LayerShader& shader,
    const std::function<void()>& draw);
  /// Binds the image as the framebuffer and calls \a draw, which composites over it.
  void Composite(vtkOpenGLRenderWindow* window, const std::function<void()>& draw);

  /// Composites the image over the viewport. Further calls do nothing until Clear is called.
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

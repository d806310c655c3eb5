// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ImageUpsampler_h
#define interlume_ImageUpsampler_h

#include "Offscreen/ImageQuad.h"

#include "vtkSmartPointer.h"

#include <glm/mat4x4.hpp>

class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

namespace interlume
{

/**
 * @class   ImageUpsampler
 * @brief   upsamples an image to the viewport and preserves the edges of surfaces
 *
 * Each pixel of the image contains the volumes up to the surface visible at the pixel's center.
 * Pixels whose surfaces differ much in depth must not be blended. Each pixel of the viewport is
 * therefore interpolated from those adjacent image pixels whose surface has about the same depth as
 * its own. Surfaces narrower than a pixel of the image may be lost.
 */
class ImageUpsampler
{
public:
  ImageUpsampler();
  ~ImageUpsampler();

  /// Sets the depths of the surfaces at which the volumes in the next image end (\a surfaces) and
  /// begin (\a front). The textures have the size of the viewport. \a front is null if the volumes
  /// begin at the camera. Both are null if there are no surfaces.
  void SetDepths(
    vtkTextureObject* surfaces, vtkTextureObject* front, const glm::dmat4& unitFromClip);

  /// Composites the image over the viewport. Returns false, and draws nothing, if there are no
  /// depths or if they do not have a higher resolution than the image.
  bool Show(vtkOpenGLRenderWindow* window, vtkTextureObject* image);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkSmartPointer<vtkTextureObject> Surfaces;
  vtkSmartPointer<vtkTextureObject> Front;
  glm::dmat4 UnitFromClip{ 1.0 };
  ImageQuad Quad;
};

}

#endif
